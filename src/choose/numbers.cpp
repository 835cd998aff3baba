// SPDX-License-Identifier: MIT
#include "choose/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/phrase.h"
#include "measure/theory.h"
#include "response/pair_force.h"
#include "scene/sphere_index.h"

namespace ballpit {

namespace {

using std::numbers::pi;

constexpr double kTouching = 1e-3;      // of the sum of radii: gaps that a chain of resting spheres may have
constexpr double kRandomPacking = 0.6;  // of a heap in space
constexpr double kPlanarPacking = 0.82;

/// In the plane the area.
double volume_of(double radius, int dimensions) {
  return dimensions == 2 ? pi * radius * radius : 4.0 / 3.0 * pi * radius * radius * radius;
}

double extent(const Domain& domain, int axis) { return domain.max[axis] - domain.min[axis]; }

/// The axis along which gravity mainly acts.
int axis_of_gravity(const Vec3d& g) {
  int axis = 1;
  for (int k = 0; k < 3; ++k) axis = std::fabs(g[k]) > std::fabs(g[axis]) ? k : axis;
  return axis;
}

/// [m] The height above the lowest place that the sphere can have.
double height_of(const Scene& scene, size_t i, int axis) {
  const double r = scene.bodies.radius[i], x = scene.bodies.position[i][axis];
  const double height =
      scene.physics.gravity[axis] < 0 ? x - r - scene.domain.min[axis] : scene.domain.max[axis] - r - x;
  return std::max(0.0, height);
}

void measure_sizes(const Scene& scene, SceneNumbers& n) {
  const Bodies& b = scene.bodies;
  const auto [r_min, r_max] = std::ranges::minmax(b.radius);
  const auto [m_min, m_max] = std::ranges::minmax(b.mass);
  n.radius_min = r_min, n.radius_max = r_max, n.mass_min = m_min, n.mass_max = m_max;
  n.has_equal_radii = r_min == r_max, n.has_equal_masses = m_min == m_max;
  double spheres = 0, box = 1;
  for (const double r : b.radius) spheres += volume_of(r, n.dimensions);
  for (int axis = 0; axis < n.dimensions; ++axis) box *= extent(scene.domain, axis);
  n.packing = spheres / box;
  for (const Vec3d& p : b.position) {
    for (int axis = 0; axis < n.dimensions; ++axis) n.reach = std::max(n.reach, std::fabs(p[axis]));
  }
  bool is_flat = n.dimensions == 3 && scene.physics.gravity.z == 0;
  for (size_t i = 0; i < b.radius.size() && is_flat; ++i) {
    is_flat = b.position[i].z == b.position[0].z && b.velocity[i].z == 0;
  }
  n.is_planar_motion = n.dimensions == 2 || is_flat;
}

/// `fall` [m] is the height that each sphere can fall.
void measure_speeds(const Scene& scene, const std::vector<double>& fall, SceneNumbers& n) {
  const Bodies& b = scene.bodies;
  double squares = 0, heights = 0;
  size_t fastest = 0;
  for (size_t i = 0; i < b.radius.size(); ++i) {
    const double v2 = dot(b.velocity[i], b.velocity[i]);
    squares += v2, heights += fall[i];
    const double speed = std::sqrt(v2 + 2 * n.gravity * fall[i]);
    if (speed > n.largest_speed) n.largest_speed = speed, fastest = i;
  }
  const auto count = static_cast<double>(n.count);
  n.typical_speed = std::sqrt(std::max(squares / count, 2 * n.gravity * heights / count));
  double smallest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < b.radius.size(); ++i) {
    if (i != fastest) smallest = std::min(smallest, b.radius[i]);
  }
  n.narrowest = b.radius[fastest] + (n.count > 1 ? smallest : b.radius[fastest]);
}

/// Of equal spheres in equilibrium: Γ = (2d/√π)·(Z − 1)·√(kT/m)/σ, with Z by Carnahan and Starling, or in the plane by
/// Henderson 1975 (doi 10.1080/00268977500102511).
double rate_by_kinetic_theory(const SceneNumbers& n, double mean_radius) {
  const double d = n.dimensions, eta = std::min(n.packing, d == 3 ? kRandomPacking : kPlanarPacking);
  const double z = d == 3 ? carnahan_starling_z(6 * eta / pi) : (1 + eta * eta / 8) / ((1 - eta) * (1 - eta));
  return 2 * d / std::sqrt(pi) * (z - 1) * n.typical_speed / std::sqrt(d) / (2 * mean_radius);
}

/// Finds the longest chain of spheres that touch, one higher than the other, the largest overlap, and how far each
/// sphere can fall [m]: not at all if it stands on the floor or on others that do.
double longest_chain(const Scene& scene, int axis, SceneNumbers& n, std::vector<double>& fall) {
  const Bodies& b = scene.bodies;
  const double up = scene.physics.gravity[axis] < 0 ? 1 : -1;
  std::vector<int32_t> order(b.radius.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int32_t i) { return up * b.position[size_t(i)][axis]; });
  std::vector<double> level(b.radius.size(), 1), load = b.mass;
  SphereIndex below(scene.domain);
  double longest = 1;
  const bool can_fall = n.has_gravity && scene.domain.boundary != Boundary::periodic;
  fall.assign(b.radius.size(), 0);
  for (const int32_t i : order) {
    const auto k = static_cast<size_t>(i);
    const double height = can_fall ? height_of(scene, k, axis) : 0;
    fall[k] = height > kTouching * b.radius[k] ? height : 0;
    below.visit_near(b.position[k], b.radius[k], kTouching, [&](const SphereIndex::Sphere& other, double distance2) {
      level[k] = std::max(level[k], level[size_t(other.id)] + 1);
      load[k] = std::max(load[k], load[size_t(other.id)] + b.mass[k]);
      if (fall[size_t(other.id)] == 0) fall[k] = 0;
      const double overlap = b.radius[k] + other.radius - std::sqrt(distance2);
      n.start_overlap = std::max(n.start_overlap, overlap / std::min(b.radius[k], other.radius));
      return false;
    });
    longest = std::max(longest, level[k]);
    n.load = std::max(n.load, load[k]);
    below.insert(i, b.position[k], b.radius[k]);
  }
  return longest;
}

/// The layers of a heap of all spheres on the floor.
double layers_of_heap(const Scene& scene, const SceneNumbers& n, int axis, double mean_radius) {
  double spheres = 0, floor = 1;
  for (const double r : scene.bodies.radius) spheres += volume_of(r, n.dimensions);
  for (int k = 0; k < n.dimensions; ++k) floor *= k == axis ? 1 : extent(scene.domain, k);
  return spheres / floor / (n.dimensions == 2 ? kPlanarPacking : kRandomPacking) / (2 * mean_radius);
}

/// [s] A ball that falls from height h comes to rest after √(2h/g)·(1 + e)/(1 − e). Many do so earlier, by hitting each
/// other: Haff's law leaves a tenth of the energy after 2.16·τ, τ = 6/((1 − e²)·Γ).
double time_to_rest(const Scene& scene, const SceneNumbers& n) {
  const double e = std::min(scene.physics.restitution, scene.physics.wall_restitution);
  if (!n.has_gravity || !n.loses_energy || scene.domain.boundary == Boundary::periodic) {
    return std::numeric_limits<double>::infinity();
  }
  const double speed = std::max(n.typical_speed, std::sqrt(2 * n.gravity * 1e-3 * n.radius_min));
  const double of_one = speed / n.gravity * (1 + e) / (1 - e);
  const double loss = (1 - scene.physics.restitution * scene.physics.restitution) * n.collision_rate;
  return loss > 0 ? std::min(of_one, 2.16 * 6 / loss) : of_one;
}

}  // namespace

double SceneNumbers::float_steps(double dt) const {
  const double half = frozen_step(reach);
  return half > 0 ? typical_speed * dt / half : std::numeric_limits<double>::infinity();
}

SceneNumbers numbers_of(const Scene& scene) {
  SceneNumbers n;
  n.count = scene.bodies.size();
  n.dimensions = scene.domain.dimensions;
  n.gravity = length(scene.physics.gravity);
  n.has_gravity = n.gravity > 0;
  const bool has_walls = scene.domain.boundary != Boundary::periodic;
  n.loses_energy = (n.count > 1 && scene.physics.restitution < 1) || (has_walls && scene.physics.wall_restitution < 1);
  n.rest_time = std::numeric_limits<double>::infinity();
  if (n.count == 0) return n;
  const int axis = axis_of_gravity(scene.physics.gravity);
  measure_sizes(scene, n);
  std::vector<double> fall;
  const double chain = longest_chain(scene, axis, n, fall);
  measure_speeds(scene, fall, n);
  const double mean_radius =
      std::accumulate(scene.bodies.radius.begin(), scene.bodies.radius.end(), 0.0) / static_cast<double>(n.count);
  n.collision_rate = n.count > 1 ? rate_by_kinetic_theory(n, mean_radius) : 0;
  const double mean_mass =
      std::accumulate(scene.bodies.mass.begin(), scene.bodies.mass.end(), 0.0) / static_cast<double>(n.count);
  if (n.has_gravity && has_walls) {
    const double heap = layers_of_heap(scene, n, axis, mean_radius);
    n.layers = std::max({1.0, chain, heap});
    n.load = std::max(n.load, heap * mean_mass);
  }
  n.rest_time = time_to_rest(scene, n);
  const double speed = std::max(n.typical_speed, 1e-300), mu = n.mass_min / 2;
  const double zeta = damping_of(scene.physics.restitution, false);
  n.contact_duration = scene.physics.law == "hertz" ? hertz_duration(scene.physics.stiffness, mu, speed)
                                                    : contact_duration(scene.physics.stiffness, mu, zeta);
  return n;
}

std::vector<NamedNumber> named_numbers(const SceneNumbers& n, double dt) {
  return {{"count", "N", double(n.count), "spheres"},
          {"dimensions", "d", double(n.is_planar_motion ? 2 : n.dimensions), "dimensions in which anything moves"},
          {"packing_fraction", "η", n.packing, "packing fraction: volume of the spheres in that of the domain"},
          {"collision_rate", "Γ", n.collision_rate, "collisions of a sphere in a second, by kinetic theory"},
          {"contact_share", "Γ·t_c", n.collision_rate * n.contact_duration,
           "part of its time that a sphere is in contact, with the scene's springs"},
          {"flight", "v·dt/D", n.flight(dt),
           "way of the fastest sphere in a step, in diameters; from 1 on it may pass through others"},
          {"layers", "n", n.layers, "spheres on top of each other, once they lie"},
          {"size_ratio", "q", n.size_ratio(), "largest radius by smallest"},
          {"mass_ratio", "R", n.mass_ratio(), "largest mass by smallest"},
          {"float_steps", "v·dt/ulp", n.float_steps(dt) / 2,
           "way of a typical sphere in a step, in distances of neighbouring floats at the border"}};
}

double stable_step(const Scene& scene, const SceneNumbers& n) {
  constexpr double kFcc = 0.70710678;
  double stiffness = scene.physics.stiffness;
  if (scene.physics.law == "hertz") {
    const double speed = n.typical_speed, mu = n.mass_min / 2;
    const double overlap = std::pow(5 * mu * speed * speed / (4 * stiffness), 0.4);
    stiffness *= 1.5 * std::sqrt(std::max(overlap, 1e-6 * n.radius_min));
  }
  return stiffness > 0 ? kFcc * std::sqrt(n.mass_min / stiffness) : std::numeric_limits<double>::infinity();
}

}  // namespace ballpit
