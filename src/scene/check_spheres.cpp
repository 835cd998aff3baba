// SPDX-License-Identifier: MIT
#include "scene/check_spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace ballpit {

namespace {

constexpr std::string_view kAxes = "xyz";

Place place_of(const SphereLines& lines, int64_t i) { return {lines.file, lines.line[static_cast<size_t>(i)]}; }

std::string key_of(const SphereLines& lines, int axis) {
  return lines.csv ? std::string(1, kAxes[static_cast<size_t>(axis)]) : fmt::format("[[spheres]] position[{}]", axis);
}

/// Whether x is in the domain, or in the domain rounded to single precision. A world in single precision writes positions of
/// the rounded domain, and must read them back unchanged.
bool is_in_period(const Domain& domain, int axis, double x) {
  const double low = domain.min[axis], high = domain.max[axis];
  return (x >= low && x < high) || (x >= double(static_cast<float>(low)) && x < double(static_cast<float>(high)));
}

/// The image of x in [min, max).
double wrapped(const Domain& domain, int axis, double x) {
  const double low = domain.min[axis], period = domain.max[axis] - low;
  x -= period * std::floor((x - low) / period);
  return x >= low && x < domain.max[axis] ? x : low;
}

/// [m] By how much rounding to single precision may move two spheres towards each other, or one towards a wall.
double rounding_at(const Domain& domain, const Vec3d& p) {
  double largest = 0.0;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    largest = std::max({largest, std::abs(domain.min[axis]), std::abs(domain.max[axis]), std::abs(p[axis])});
  }
  return 2.0 * double(std::numeric_limits<float>::epsilon()) * largest;
}

void check_walls(const Domain& domain, const SphereLines& lines, int64_t i, int axis, double x, double radius,
                 double tolerance) {
  const bool open = domain.boundary == Boundary::open_top && axis == 1;
  const bool below = x - radius < domain.min[axis] - tolerance;
  const bool above = x + radius > domain.max[axis] + tolerance;
  if (!below && (!above || open)) return;
  throw input_error(
      place_of(lines, i), key_of(lines, axis),
      fmt::format("sphere {} reaching from {}", i, limits_text({x - radius, x + radius})),
      (open ? "above " + number_text(domain.min[axis]) : limits_text({domain.min[axis], domain.max[axis]})) +
          ", the domain");
}

/// Returns whether it has moved sphere i from outside of a periodic domain to its image inside.
bool check_inside(const Domain& domain, const Physics& physics, const SphereLines& lines, int64_t i, Bodies& bodies) {
  const auto k = static_cast<size_t>(i);
  bool was_outside = false;
  if (domain.dimensions == 2) bodies.position[k].z = bodies.velocity[k].z = 0.0;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    if (domain.boundary == Boundary::periodic) {
      double& x = bodies.position[k][axis];
      if (is_in_period(domain, axis, x)) continue;
      was_outside |= x != domain.max[axis];  // max is the same point as min
      x = wrapped(domain, axis, x);
    } else {
      check_walls(domain, lines, i, axis, bodies.position[k][axis], bodies.radius[k],
                  physics.initial_overlap * bodies.radius[k] + rounding_at(domain, bodies.position[k]));
    }
  }
  return was_outside;
}

[[noreturn]] void fail_overlap(const SphereLines& lines, int64_t i, int64_t j, double overlap, double smaller,
                               double allowed) {
  throw input_error(place_of(lines, j), lines.csv ? "x" : "[[spheres]] position",
                    fmt::format("spheres {} (line {}) and {} overlapping by {} m, {} of the smaller radius", i,
                                place_of(lines, i).line, j, number_text(overlap), number_text(overlap / smaller)),
                    number_text(allowed) + ", see [physics] initial_overlap");
}

}  // namespace

int64_t check_spheres(const Domain& domain, const Physics& physics, const SphereLines& lines, Bodies& bodies,
                      SphereIndex& index) {
  int64_t wrapped = 0;
  for (int64_t i = 0; i < bodies.size(); ++i) wrapped += check_inside(domain, physics, lines, i, bodies);
  const bool may_overlap = physics.initial_overlap >= kAnyOverlap;

  // The largest first: each search then visits only spheres of its own size or larger, and few of these are within reach.
  for (const int32_t i : by_descending_radius(bodies.radius, 0, bodies.size())) {
    const auto k = static_cast<size_t>(i);
    const double radius = bodies.radius[k];
    index.visit_near(bodies.position[k], radius, 0.0, [&](const SphereIndex::Sphere& other, double distance2) {
      const double overlap = radius + other.radius - std::sqrt(distance2);
      if (may_overlap) return false;
      if (overlap <= physics.initial_overlap * radius + rounding_at(domain, bodies.position[k])) return false;
      const auto [first, second] = std::minmax(i, other.id);
      fail_overlap(lines, first, second, overlap, radius, physics.initial_overlap);
    });
    index.insert(i, bodies.position[k], radius);
  }
  return wrapped;
}

void check_periodic_edges(const Domain& domain, double largest_radius, const Place& place) {
  if (domain.boundary != Boundary::periodic) return;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const double edge = domain.max[axis] - domain.min[axis];
    // The difference of two rounded numbers has their rounding errors: 0.3 − 0.1 < 0.2.
    const double rounding = 2.0 * std::numeric_limits<double>::epsilon() *
                            std::max({std::abs(domain.min[axis]), std::abs(domain.max[axis]), 4.0 * largest_radius});
    if (edge >= 4.0 * largest_radius - rounding) continue;
    throw input_error(place, "[domain] max",
                      fmt::format("an edge of {} along {} with radius {}", number_text(edge),
                                  kAxes[static_cast<size_t>(axis)], number_text(largest_radius)),
                      fmt::format("at least four radii, {}, in a periodic domain", number_text(4.0 * largest_radius)));
  }
}

}  // namespace ballpit
