// SPDX-License-Identifier: MIT
#include "choose/needs_meter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "core/phrase.h"

namespace ballpit {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kDefaultOverlap = 0.05, kDefaultEnergy = 0.01;

/// [J] The potential energy that all spheres would have in the corner of the domain that lies lowest.
double energy_at_bottom(const Scene& scene, const Bodies& bodies) {
  const Vec3d& g = scene.physics.gravity;
  double per_mass = 0;
  for (int axis = 0; axis < 3; ++axis) {
    per_mass -= g[axis] * (g[axis] < 0 ? scene.domain.min[axis] : scene.domain.max[axis]);
  }
  return per_mass * std::accumulate(bodies.mass.begin(), bodies.mass.end(), 0.0);
}

double relative(double change, double of) { return change == 0 ? 0 : change / of; }

double distance(const Domain& domain, Vec3d d) {
  for (int axis = 0; axis < domain.dimensions && domain.boundary == Boundary::periodic; ++axis) {
    const double period = domain.max[axis] - domain.min[axis];
    d[axis] -= period * std::round(d[axis] / period);
  }
  return length(d);
}

}  // namespace

/// What the rows of the table see of a meter.
struct NeedRow {
  struct Now {
    const NeedsMeter& meter;
    const Report& report;
    const Bodies& bodies;
    const Truth& truth;
  };

  std::string_view name;
  std::optional<double> Needs::*allowed;
  bool grows;
  double (*error)(const Now&);

  static double overlap(const Now& now) { return now.report.max_overlap; }
  static double overlap_ever(const Now& now) { return std::max(now.meter.seen_, now.report.max_overlap); }
  static double energy(const Now& now) {
    const double change = std::fabs(energy_of(now.report) - now.meter.energy_);
    return relative(change, now.meter.energy_ - now.meter.bottom_energy_);
  }
  static double momentum(const Now& now) {
    return relative(length(now.report.momentum - now.meter.momentum_), now.meter.momentum_scale_);
  }
  static double speed(const Now& now) { return rms_speed(now.report, now.bodies); }
  static double path(const Now& now) {
    const std::vector<Vec3d>& truth = now.truth.position;
    if (truth.empty()) return now.bodies.size() == 0 ? 0 : kUnknown;
    const double late = now.report.time - now.truth.time;  // up to half a step
    std::vector<double> off;
    for (size_t i = 0; i < truth.size(); ++i) {
      const Vec3d there = truth[i] + late * now.truth.velocity[i];
      off.push_back(distance(now.meter.domain_, now.bodies.position[i] - there) / now.bodies.radius[i]);
    }
    const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
    std::nth_element(off.begin(), middle, off.end());
    return *middle;
  }

  static std::span<const NeedRow> table() {
    static constexpr std::array kRows{
        NeedRow{"max_overlap", &Needs::max_overlap, false, overlap},
        NeedRow{"max_overlap_ever", &Needs::max_overlap_ever, false, overlap_ever},
        NeedRow{"energy_tolerance", &Needs::energy_tolerance, true, energy},
        NeedRow{"momentum_tolerance", &Needs::momentum_tolerance, true, momentum},
        NeedRow{"max_speed", &Needs::max_speed, false, speed},
        NeedRow{"path_tolerance", &Needs::path_tolerance, true, path},
    };
    return kRows;
  }
};

EffectiveNeeds effective_needs(const Scene& scene) {
  EffectiveNeeds result{scene.needs, ""};
  Needs& needs = result.needs;
  constexpr double kDefaultPath = 0.1;
  if (needs.has(Effect::paths) && !needs.path_tolerance) needs.path_tolerance = kDefaultPath;
  if (needs.are_declared) return result;
  needs.max_overlap = kDefaultOverlap;
  const bool is_periodic = scene.domain.boundary == Boundary::periodic;
  const bool falls_forever = is_periodic && length(scene.physics.gravity) > 0;
  const bool is_elastic = scene.physics.restitution == 1 && (is_periodic || scene.physics.wall_restitution == 1);
  if (is_elastic && !falls_forever) needs.energy_tolerance = kDefaultEnergy;
  result.note = phrase("the scene has no [needs]: taken are duration = {}, max_overlap = {}{}", needs.duration,
                       kDefaultOverlap, needs.energy_tolerance ? ", energy_tolerance = 0.01" : "");
  return result;
}

std::vector<Tolerance> tolerances_of(const Needs& needs) {
  std::vector<Tolerance> result;
  for (const NeedRow& row : NeedRow::table()) {
    if (needs.*row.allowed) result.push_back({std::string(row.name), *(needs.*row.allowed), row.grows});
  }
  for (const NeededObservable& o : needs.observables) result.push_back({o.name, o.tolerance, false});
  return result;
}

void check_observables(const Needs& needs) {
  for (const NeededObservable& o : needs.observables) entry_named(observables(), o.name, o.where);
}

bool need_tally(const Needs& needs) {
  return std::ranges::any_of(needs.observables, [](const NeededObservable& o) {
    return entry_named(observables(), o.name, o.where).needs_tally;
  });
}

double energy_of(const Report& report) {
  return report.kinetic_energy + report.potential_energy + report.elastic_energy;
}

double rms_speed(const Report& report, const Bodies& bodies) {
  const double mass = std::accumulate(bodies.mass.begin(), bodies.mass.end(), 0.0);
  return mass > 0 ? std::sqrt(2 * report.kinetic_energy / mass) : 0;
}

NeedsMeter::NeedsMeter(const Scene& scene, Needs needs, World& world, double seen_before)
    : domain_(scene.domain),
      needs_(std::move(needs)),
      observer_(scene.domain, 0,
                std::ranges::any_of(needs_.observables,
                                    [](const NeededObservable& o) {
                                      return entry_named(ballpit::observables(), o.name, o.where).needs_ways;
                                    })),
      seen_(seen_before) {
  const Report report = world.report();
  const Bodies bodies = world.bodies();
  bottom_energy_ = energy_at_bottom(scene, bodies);
  energy_ = energy_of(report);
  momentum_ = report.momentum;
  momentum_scale_ = 0;
  for (size_t i = 0; i < bodies.mass.size(); ++i) momentum_scale_ += bodies.mass[i] * length(bodies.velocity[i]);
  if (needs_.max_overlap_ever) seen_ = std::max(seen_, report.max_overlap);
  observer_.look(world);
}

void NeedsMeter::look(World& world) {
  if (needs_.max_overlap_ever) seen_ = std::max(seen_, world.report().max_overlap);
  if (!needs_.observables.empty()) observer_.look(world);
}

std::vector<ObservedValue> NeedsMeter::observables(World& world, const Report& report) const {
  std::vector<ObservedValue> result;
  if (needs_.observables.empty()) return result;
  const Observation observation = observer_.observation(world, report);
  for (const NeededObservable& o : needs_.observables) {
    result.push_back(measure(entry_named(ballpit::observables(), o.name, o.where), observation));
  }
  return result;
}

std::vector<double> NeedsMeter::errors(World& world, const Truth& truth) const {
  const Report report = world.report();
  const Bodies bodies = world.bodies();
  const NeedRow::Now now{*this, report, bodies, truth};
  std::vector<double> result;
  for (const NeedRow& row : NeedRow::table()) {
    if (needs_.*row.allowed) result.push_back(row.error(now));
  }
  const std::vector<ObservedValue> observed = observables(world, report);
  for (size_t k = 0; k < observed.size(); ++k) {
    if (truth.observables.size() <= k || observed[k].size() != truth.observables[k].size() || observed[k].empty()) {
      result.push_back(kUnknown);
      continue;
    }
    double off = 0, size = 0;
    for (size_t axis = 0; axis < observed[k].size(); ++axis) {
      off = std::hypot(off, observed[k][axis] - truth.observables[k][axis]);
      size = std::hypot(size, truth.observables[k][axis]);
    }
    result.push_back(relative(off, size));
  }
  return result;
}

Truth NeedsMeter::truth(World& world) const {
  const Report report = world.report();
  const Bodies bodies = world.bodies();
  return {report.time, bodies.position, bodies.velocity, observables(world, report)};
}

}  // namespace ballpit
