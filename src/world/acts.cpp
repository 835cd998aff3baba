// SPDX-License-Identifier: MIT
#include "world/acts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "core/numbers.h"

namespace ballpit {

namespace {

constexpr double kTouching = 1e-6;  // of the smaller radius: as much overlap as a scene may start with

[[noreturn]] void fail(const Act& act, const std::string& reason) {
  throw RunError(fmt::format("{} at t = {} s", kActNames[size_t(act.kind)], number_text(act.time)), reason);
}

void check_room(const Act& act, const Domain& domain, const Bodies& bodies) {
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    const double overlap = act.radius + bodies.radius[i] - distance_in(domain, act.vector, bodies.position[i]);
    if (overlap <= kTouching * std::min(act.radius, bodies.radius[i])) continue;
    fail(act, fmt::format("no room for a sphere of radius {:.3g} m at ({:.3g}, {:.3g}, {:.3g}): sphere {} is {:.2g} m "
                          "too near",
                          act.radius, act.vector.x, act.vector.y, act.vector.z, i, overlap));
  }
}

}  // namespace

double distance_in(const Domain& domain, const Vec3d& a, const Vec3d& b) {
  Vec3d d = b - a;
  for (int axis = 0; axis < domain.dimensions && domain.boundary == Boundary::periodic; ++axis) {
    const double period = domain.max[axis] - domain.min[axis];
    d[axis] -= period * std::round(d[axis] / period);
  }
  return length(d);
}

Bodies acted(const Act& act, const Domain& domain, Bodies bodies) {
  if (act.kind == ActKind::drop) {
    check_room(act, domain, bodies);
    bodies.position.push_back(act.vector);
    bodies.velocity.emplace_back(0.0);
    bodies.radius.push_back(act.radius);
    bodies.mass.push_back(act.mass);
    return bodies;
  }
  if (act.sphere < 0 || act.sphere >= bodies.size()) fail(act, fmt::format("there is no sphere {}", act.sphere));
  const auto chosen = static_cast<size_t>(act.sphere);
  if (act.kind == ActKind::to_throw) {
    bodies.velocity[chosen] = act.vector;
    return bodies;
  }
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    const bool is_near = distance_in(domain, bodies.position[chosen], bodies.position[i]) <= act.reach;
    if (i == chosen || is_near) bodies.velocity[i] += act.vector;
  }
  return bodies;
}

int64_t Acts::count_until(double time) const {
  const auto later = std::upper_bound(acts_.begin(), acts_.end(), time + tolerance_,
                                      [](double limit, const Act& act) { return limit < act.time; });
  return later - acts_.begin();
}

std::optional<double> Acts::energy_after(double time) const {
  const auto count = static_cast<size_t>(count_until(time));
  return count > 0 && count <= energy_.size() ? std::optional(energy_[count - 1]) : std::nullopt;
}

bool Acts::begin(World& world) {
  const auto end = static_cast<size_t>(count_until(world.time()));
  apply(world, 0, end);
  return end > 0;
}

bool Acts::step(World& world) {
  const auto first = static_cast<size_t>(count_until(world.time()));
  world.step();
  const auto end = static_cast<size_t>(count_until(world.time()));
  apply(world, first, end);
  return end > first;
}

/// Applies acts `first` (included) to `end` (excluded).
void Acts::apply(World& world, size_t first, size_t end) {
  if (first == end) return;
  Bodies bodies = world.bodies();
  for (size_t k = first; k < end; ++k) bodies = acted(acts_[k], domain_, std::move(bodies));
  world.replace(bodies);
  const Report now = world.report();
  energy_.resize(std::max(energy_.size(), end));
  std::fill(energy_.begin() + std::ptrdiff_t(first), energy_.begin() + std::ptrdiff_t(end),
            now.kinetic_energy + now.potential_energy + now.elastic_energy);
}

void Acts::add(Act act, World& world) {
  act.time = world.time();
  if (act.kind == ActKind::drop) act.sphere = world.shape().count;
  acted(act, domain_, world.bodies());  // throws before anything has changed
  const auto before = static_cast<size_t>(count_until(act.time));
  if (before > 0) act.time = std::max(act.time, acts_[before - 1].time);  // both belong to this step
  acts_.resize(before);
  energy_.resize(std::min(energy_.size(), before));
  acts_.push_back(act);
  apply(world, before, before + 1);
}

}  // namespace ballpit
