// SPDX-License-Identifier: MIT
// Hits and lattices with known outcomes, shared by the tests of responses and integrators.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/scenes.h"

namespace ballpit {

/// A large box without gravity and without losses.
inline Scene wide_box(double half = 50.0) {
  Scene scene;
  scene.domain.min = Vec3d(-half);
  scene.domain.max = Vec3d(half);
  scene.physics.restitution = scene.physics.wall_restitution = 1.0;
  return scene;
}

inline Settings settings_of(const std::string& response, double dt, const std::string& integrator = "auto") {
  Settings settings;
  settings.response = named<Response>(response);
  settings.integrator = named<Integrator>(integrator);
  settings.precision = Precision::float64;
  settings.broadphase = BroadPhase::brute_force;
  settings.dt = dt;
  settings.threads = 1;
  return settings;
}

inline void step_until(World& world, double time) {
  while (world.time() < time) world.step();
}

/// Two spheres of mass 1 and diameter 1 that meet head-on at `speed` [m/s], `gap` apart [m].
inline Scene head_on(double speed, double gap) {
  Scene scene = wide_box();
  add_sphere(scene, {-0.5 - gap / 2, 0, 0}, {speed / 2, 0, 0}, 0.5, 1.0);
  add_sphere(scene, {0.5 + gap / 2, 0, 0}, {-speed / 2, 0, 0}, 0.5, 1.0);
  return scene;
}

inline double parting_speed(World& world) {
  const Bodies bodies = world.bodies();
  return bodies.velocity[1].x - bodies.velocity[0].x;
}

/// A row of touching spheres of mass 1 and diameter 1 along x; the first one moves at 1 m/s.
inline Scene cradle(int count) {
  Scene scene = wide_box();
  for (int k = 0; k < count; ++k) add_sphere(scene, {k - count / 2.0, 0, 0}, Vec3d(k == 0 ? 1 : 0, 0, 0), 0.5, 1.0);
  return scene;
}

inline std::vector<double> speeds_along_x(World& world) {
  std::vector<double> result;
  for (const Vec3d& v : world.bodies().velocity) result.push_back(v.x);
  return result;
}

}  // namespace ballpit
