// SPDX-License-Identifier: MIT
// Stepped worlds and their exact ghosts, for tests.
#pragma once

#include "tests/support/hits.h"
#include "world/ghost.h"

namespace ballpit {

inline Settings stepping(const std::string& response, double dt, bool is_swept = false) {
  Settings settings = settings_of(response, dt);
  settings.is_swept = is_swept;
  return settings;
}

/// A world and its ghost, dropped at the start.
struct Haunted {
  Haunted(const Scene& scene, const Settings& settings)
      : dt(settings.dt), world(make_cpu_world(scene, settings)), ghost(scene, settings, *world, 0) {}

  GhostInspection step(int steps) {
    for (int k = 0; k < steps; ++k) {
      world->step();
      ghost.follow(*world, world->time(), dt);
    }
    return now();
  }
  GhostInspection now() { return ghost.inspect(*world, world->time(), dt, false); }

  double dt;
  std::unique_ptr<World> world;
  Ghost ghost;
};

/// Two spheres of radius 0.1 m and mass 1 kg that meet head-on at 1 m/s after 0.353 s, at x = 0.7765 m.
inline Scene meeting() {
  Scene scene;
  scene.domain.max = {2, 1, 1};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  scene.physics.stiffness = 1e5;
  add_sphere(scene, {0.5, 0.5, 0.5}, {0.5, 0, 0}, 0.1);
  add_sphere(scene, {1.053, 0.5, 0.5}, {-0.5, 0, 0}, 0.1);
  return scene;
}

}  // namespace ballpit
