// SPDX-License-Identifier: MIT
#include "scene/check_spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ballpit {

namespace {

constexpr std::string_view kAxes = "xyz";

Place place_of(const SphereLines& lines, int64_t i) { return {lines.file, lines.line[static_cast<size_t>(i)]}; }

std::string key_of(const SphereLines& lines, int axis) {
  return lines.csv ? std::string(1, kAxes[static_cast<size_t>(axis)])
                   : "[[spheres]] position[" + std::to_string(axis) + "]";
}

/// Whether x is in the domain, or in the domain as a world in single precision rounds it: such a world writes states
/// from there, and is to find the same bits in them.
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

/// [m] What rounding to single precision moves two spheres towards each other, or one towards a wall.
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
      "sphere " + std::to_string(i) + " reaching from " + number_text(x - radius) + " to " + number_text(x + radius),
      (open ? "above " + number_text(domain.min[axis]) : limits_text({domain.min[axis], domain.max[axis]})) +
          ", the domain");
}

/// Returns whether sphere i was outside of a periodic domain, and is inside now.
bool check_inside(const Domain& domain, const Physics& physics, const SphereLines& lines, int64_t i, Bodies& bodies) {
  const auto k = static_cast<size_t>(i);
  bool was_outside = false;
  if (domain.dimensions == 2) bodies.position[k].z = bodies.velocity[k].z = 0.0;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    if (domain.boundary == Boundary::periodic) {
      double& x = bodies.position[k][axis];
      if (is_in_period(domain, axis, x)) continue;
      was_outside |= x != domain.max[axis];  // which is the same point as min
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
                    "spheres " + std::to_string(i) + " (line " + std::to_string(place_of(lines, i).line) + ") and " +
                        std::to_string(j) + " overlapping by " + number_text(overlap) + " m, " +
                        number_text(overlap / smaller) + " of the smaller radius",
                    number_text(allowed) + ", see [physics] initial_overlap");
}

}  // namespace

int64_t check_spheres(const Domain& domain, const Physics& physics, const SphereLines& lines, Bodies& bodies,
                      SphereIndex& index) {
  int64_t wrapped = 0;
  for (int64_t i = 0; i < bodies.size(); ++i) wrapped += check_inside(domain, physics, lines, i, bodies);
  const bool may_overlap = physics.initial_overlap >= kAnyOverlap;

  // The largest first: then each search is among spheres of its own size or larger, which are few within
  // reach.
  std::vector<int32_t> order(static_cast<size_t>(bodies.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int32_t i, int32_t j) {
    return bodies.radius[static_cast<size_t>(i)] > bodies.radius[static_cast<size_t>(j)];
  });
  for (const int32_t i : order) {
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
    // The difference of two rounded numbers is off by their rounding: 0.3 − 0.1 < 0.2.
    const double rounding = 2.0 * std::numeric_limits<double>::epsilon() *
                            std::max({std::abs(domain.min[axis]), std::abs(domain.max[axis]), 4.0 * largest_radius});
    if (edge >= 4.0 * largest_radius - rounding) continue;
    throw input_error(place, "[domain] max",
                      "an edge of " + number_text(edge) + " along " + kAxes[static_cast<size_t>(axis)] +
                          " with radius " + number_text(largest_radius),
                      "at least four radii, " + number_text(4.0 * largest_radius) + ", in a periodic domain");
  }
}

}  // namespace ballpit
