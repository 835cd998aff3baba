// SPDX-License-Identifier: MIT
#include "scene/check_spheres.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ballpit {

namespace {

constexpr std::string_view kAxes = "xyz";

Place place_of(const SphereLines& lines, int64_t i) { return {lines.file, lines.line[static_cast<size_t>(i)]}; }

std::string key_of(const SphereLines& lines, int axis) {
  return lines.csv ? std::string(1, kAxes[static_cast<size_t>(axis)])
                   : "[[spheres]] position[" + std::to_string(axis) + "]";
}

void check_periodic(const Domain& domain, const SphereLines& lines, int64_t i, int axis, double& x) {
  if (x < domain.min[axis] || x > domain.max[axis]) {
    throw input_error(place_of(lines, i), key_of(lines, axis), number_text(x) + " for sphere " + std::to_string(i),
                      limits_text({domain.min[axis], domain.max[axis]}) + ", the domain");
  }
  // Also if it would be only after rounding to float.
  if (static_cast<float>(x) >= static_cast<float>(domain.max[axis])) x = domain.min[axis];
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

void check_inside(const Domain& domain, const Physics& physics, const SphereLines& lines, int64_t i, Bodies& bodies) {
  const auto k = static_cast<size_t>(i);
  if (domain.dimensions == 2) bodies.position[k].z = bodies.velocity[k].z = 0.0;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    if (domain.boundary == Boundary::periodic) {
      check_periodic(domain, lines, i, axis, bodies.position[k][axis]);
    } else {
      check_walls(domain, lines, i, axis, bodies.position[k][axis], bodies.radius[k],
                  physics.initial_overlap * bodies.radius[k]);
    }
  }
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

void check_spheres(const Domain& domain, const Physics& physics, const SphereLines& lines, Bodies& bodies,
                   SphereIndex& index) {
  for (int64_t i = 0; i < bodies.size(); ++i) check_inside(domain, physics, lines, i, bodies);

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
      if (!(overlap > physics.initial_overlap * radius)) return false;
      const auto [first, second] = std::minmax(i, other.id);
      fail_overlap(lines, first, second, overlap, radius, physics.initial_overlap);
    });
    index.insert(i, bodies.position[k], radius);
  }
}

void check_periodic_edges(const Domain& domain, double largest_radius, const Place& place) {
  if (domain.boundary != Boundary::periodic) return;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const double edge = domain.max[axis] - domain.min[axis];
    if (edge >= 4.0 * largest_radius) continue;
    throw input_error(place, "[domain] max",
                      "an edge of " + number_text(edge) + " along " + kAxes[static_cast<size_t>(axis)] +
                          " with radius " + number_text(largest_radius),
                      "at least four radii, " + number_text(4.0 * largest_radius) + ", in a periodic domain");
  }
}

}  // namespace ballpit
