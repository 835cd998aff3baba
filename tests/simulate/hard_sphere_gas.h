// SPDX-License-Identifier: MIT
// A gas of hard spheres in a periodic cube: diameter, mass and kT are 1, the total momentum is 0.
#pragma once

#include <cmath>

#include "core/random.h"
#include "tests/simulate/scenes.h"

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

}  // namespace ballpit
