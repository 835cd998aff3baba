// SPDX-License-Identifier: MIT
// A gas of hard spheres in a periodic cube: diameter, mass and kT are 1, the total momentum is 0.
#pragma once

#include <cmath>
#include <numeric>
#include <vector>

#include "core/random.h"
#include "tests/support/scenes.h"

namespace ballpit {

/// `cells`³ cells of an fcc lattice: N = 4·cells³ spheres at the number density rho (below √2, where they touch), with
/// random velocities of total momentum zero and kT = 2K/(3(N − 1)) = 1. It melts after some collisions per sphere, at
/// densities where the gas is the stable state.
inline Scene make_lattice_gas(int cells, double rho, uint64_t seed) {
  const double edge = std::cbrt(4 / rho);
  const Vec3d basis[] = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  Random random(seed);
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(cells * edge), Boundary::periodic, 3};
  scene.physics.restitution = 1;
  for (int c = 0; c < cells * cells * cells; ++c) {
    const Vec3d corner(c % cells, c / cells % cells, c / cells / cells);
    for (const Vec3d& b : basis) {
      const Vec3d v = random.uniform(Vec3d(-1.0), Vec3d(1.0)) + random.uniform(Vec3d(-1.0), Vec3d(1.0));
      add_sphere(scene, edge * (corner + b + 0.25), v, 0.5);
    }
  }
  Vec3d mean(0.0);
  for (const Vec3d& v : scene.bodies.velocity) mean += v / double(scene.bodies.size());
  double squared = 0;
  for (Vec3d& v : scene.bodies.velocity) squared += dot(v -= mean, v);
  for (Vec3d& v : scene.bodies.velocity) v *= std::sqrt(3.0 * double(scene.bodies.size() - 1) / squared);
  return scene;
}

/// Settings of exact motion.
inline Settings event_driven_gas(double dt) {
  Settings settings;
  settings.response = Response::event_driven;
  settings.dt = dt;
  settings.contact_duration = 0;
  return settings;
}

/// The lattice gas after 25 collisions per sphere and more: molten, its speeds those of Maxwell.
inline Scene melted_gas(int cells, double rho, uint64_t seed) {
  Scene scene = make_lattice_gas(cells, rho, seed);
  const auto world = make_cpu_world(scene, event_driven_gas(rho < 0.2 ? 40.0 : 6.0));
  world->step();
  scene.bodies = world->bodies();
  return scene;
}

struct Mean {
  double value = 0, error = 0;  ///< error: the standard error of the mean
};

inline Mean mean_of(const std::vector<double>& blocks) {
  const double n = double(blocks.size());
  const double mean = std::accumulate(blocks.begin(), blocks.end(), 0.0) / n;
  double squared = 0;
  for (const double b : blocks) squared += (b - mean) * (b - mean);
  return {mean, std::sqrt(squared / (n * (n - 1)))};
}

}  // namespace ballpit
