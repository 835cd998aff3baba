// SPDX-License-Identifier: MIT
// Scenes made in code for the tests, and worlds on the CPU.
#pragma once

#include <cmath>
#include <memory>

#include "core/random.h"
#include "scene/scene.h"
#include "world/world.h"

namespace ballpit {

/// Spheres dropped at random into [low, high], overlaps and all: what a broad phase must cope with.
struct Cloud {
  int count = 300;
  int dimensions = 3;
  double low = -1.0, high = 1.0;           ///< [m] the domain, along each axis
  double smallest = 0.05, largest = 0.05;  ///< [m] radii
  double snap = 0.0;                       ///< centres lie on multiples of it, where above 0
  int clusters = 0;                        ///< where above 0, centres gather around as many points
  Boundary boundary = Boundary::walls;
  Vec3d stretch{1.0};           ///< the domain's length along each axis, as a factor
  double scatter = 0.1;         ///< distance from a cluster's point, as a fraction of the domain
  double huge = 0.0;            ///< [m] radius of the first sphere, where above 0
  double above = 0.0;           ///< [m] how far above the domain's top centres may lie
  bool is_log_uniform = false;  ///< radii are spread evenly by their logarithm
};

inline void add_sphere(Scene& scene, const Vec3d& position, const Vec3d& velocity = Vec3d(0.0), double radius = 0.05,
                       double mass = 1.0) {
  scene.bodies.position.push_back(position);
  scene.bodies.velocity.push_back(velocity);
  scene.bodies.radius.push_back(radius);
  scene.bodies.mass.push_back(mass);
}

/// Spheres of various sizes and masses about a lattice of `side` spheres along each axis, so close that some touch soon, all
/// moving: in a box with gravity, or in a periodic one without. Radii from `smallest` to `largest` [m]; 0.065 touch.
inline Scene make_crowd(int dimensions, int side, Boundary boundary, double restitution, double smallest,
                        double largest) {
  constexpr double kPitch = 0.13;
  Random random(7);
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(side * kPitch), boundary, dimensions};
  if (boundary != Boundary::periodic) scene.physics.gravity = {0, -9.81, 0};
  scene.physics.restitution = scene.physics.wall_restitution = restitution;
  scene.physics.stiffness = 1e4;  // about 20 steps a contact
  for (int k = 0; k < side * side * (dimensions == 2 ? 1 : side); ++k) {
    const Vec3d cell(k % side, k / side % side, dimensions == 2 ? -0.5 : k / side / side);
    const double radius = random.uniform(smallest, largest);
    Vec3d p = kPitch * (cell + 0.5);
    for (int axis = 0; axis < dimensions; ++axis) p[axis] += random.uniform(-0.01, 0.01);
    add_sphere(scene, p, random.uniform(0.0, 2.0) * random.direction(dimensions), radius, std::pow(radius / 0.06, 3));
  }
  return scene;
}

inline Scene make_cloud(const Cloud& cloud, uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Vec3d low(cloud.low), high = low + (cloud.high - cloud.low) * cloud.stretch;
  const Vec3d top = high + Vec3d(0, cloud.above, 0);
  scene.domain = {low, high, cloud.boundary, cloud.dimensions};
  std::vector<Vec3d> centers;
  for (int k = 0; k < cloud.clusters; ++k) centers.push_back(random.uniform(low, top));
  for (int i = 0; i < cloud.count; ++i) {
    double radius = random.uniform(cloud.smallest, cloud.largest);
    if (cloud.is_log_uniform) {
      radius = cloud.smallest * std::pow(cloud.largest / cloud.smallest, random.uniform());
    }
    if (cloud.huge > 0 && i == 0) radius = cloud.huge;
    Vec3d p = random.uniform(low, top);
    if (!centers.empty()) {
      p = centers[static_cast<size_t>(i % cloud.clusters)] +
          cloud.scatter * (cloud.high - cloud.low) * random.direction(3);
    }
    if (cloud.snap > 0) p = glm::round(p / cloud.snap) * cloud.snap;
    p = glm::clamp(p, low, top);
    if (cloud.dimensions == 2) p.z = 0;
    add_sphere(scene, p, random.uniform() * random.direction(cloud.dimensions), radius);
  }
  return scene;
}

/// Spheres that fall and meet.
inline Scene falling_cloud(int count, int dimensions = 3) {
  Scene scene = make_cloud({.count = count, .dimensions = dimensions, .smallest = 0.05, .largest = 0.08}, 5);
  scene.physics.gravity = {0, -9.81, 0};
  for (Vec3d& p : scene.bodies.position) p = glm::clamp(p, Vec3d(-0.9), Vec3d(0.9));
  return scene;
}

inline std::unique_ptr<World> make_cpu_world(const Scene& scene, const Settings& settings = {}) {
  return cpu_backend().make_world(scene, settings);
}

}  // namespace ballpit
