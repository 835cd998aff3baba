// SPDX-License-Identifier: MIT
// Scenes and worlds that the tests of event-driven motion share.
#pragma once

#include "tests/support/scenes.h"

namespace ballpit {

inline Scene empty_box(double size = 10.0) {
  Scene scene;
  scene.domain.max = Vec3d(size);
  scene.physics.restitution = scene.physics.wall_restitution = 1.0;
  return scene;
}

/// A ball whose lowest point is 1 m above the floor; g = 9.81 m/s², e = 0.8.
inline Scene dropped_ball() {
  Scene scene = empty_box(4.0);
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.wall_restitution = 0.8;
  add_sphere(scene, {1, 1.05, 1}, Vec3d(0.0), 0.05, 2.0);
  return scene;
}

/// Spheres in a row along x, the first of them moving at 1 m/s towards the others, which touch.
inline Scene cradle(int count, double restitution) {
  Scene scene = empty_box(20.0);
  scene.physics.restitution = restitution;
  add_sphere(scene, {2, 5, 5}, {1, 0, 0}, 0.5);
  for (int k = 1; k < count; ++k) add_sphere(scene, {3.0 + k, 5, 5}, Vec3d(0.0), 0.5);
  return scene;
}

/// 60 spheres of radii 0.1 to 0.2 and various masses in a box with walls: gravity aslant, everything inelastic.
inline Scene mixed_heap() {
  Scene scene;
  scene.domain.max = {3, 3, 3};
  scene.domain.boundary = Boundary::open_top;
  scene.physics.gravity = {0.3, -9.81, 0.1};
  scene.physics.restitution = 0.7;
  scene.physics.wall_restitution = 0.9;
  Random random(5);
  for (int k = 0; k < 60; ++k) {
    const Vec3d p(0.4 + 0.55 * (k % 5), 0.4 + 0.55 * (k / 20), 0.4 + 0.6 * (k / 5 % 4));
    add_sphere(scene, p, random.uniform(Vec3d(-2.0), Vec3d(2.0)), random.uniform(0.1, 0.2), random.uniform(0.5, 2.0));
  }
  return scene;
}

inline Settings event_driven(double dt) {
  Settings settings;
  settings.response = Response::event_driven;
  settings.dt = dt;
  return settings;
}

/// The world at time t, in one step.
inline std::unique_ptr<World> world_at(const Scene& scene, double t, double contact_duration = 1e-6) {
  Settings settings = event_driven(t);
  settings.contact_duration = contact_duration;
  auto world = make_cpu_world(scene, settings);
  world->step();
  return world;
}

inline double total_energy(const Report& report) { return report.kinetic_energy + report.potential_energy; }

}  // namespace ballpit
