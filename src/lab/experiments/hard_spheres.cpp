// SPDX-License-Identifier: MIT
#include "lab/experiments/hard_spheres.h"

#include <cmath>

#include "lab/measure/made_scenes.h"
#include "lab/measure/theory.h"

namespace ballpit {

double count_of(const GasRun& run) { return 4.0 * run.cells * run.cells * run.cells; }

std::vector<double> block_z(const GasRun& run, const Settings& settings) {
  return block_z(run, settings, equilibrium_gas(run.cells, run.rho, run.seed));
}

std::vector<double> block_z(const GasRun& run, const Settings& settings, const Scene& gas) {
  const double count = count_of(run), block = run.collisions / collision_rate(run.rho, count);
  Settings own = settings;
  own.keeps_tally = true;
  if (settings.response == Response::event_driven) own.dt = block;
  Scene scene = gas;
  std::vector<double> values;
  for (int k = 0; k < run.blocks; ++k) {
    const auto world = make_cpu_world(scene, own);
    const double before = world->report().kinetic_energy;
    step_until(*world, block, own.dt);
    const Report now = world->report();
    const double kt = (before + now.kinetic_energy) / (3 * (count - 1));
    values.push_back(1 + now.tally.virial / (3 * count * kt * now.time));
    scene.bodies = world->bodies();
    for (Vec3d& v : scene.bodies.velocity) v *= std::sqrt(1.5 * (count - 1) / now.kinetic_energy);
  }
  return values;
}

Settings elastic_impulses(double dt, bool is_swept) {
  Settings settings = settings_of("impulse", dt);
  settings.solver = Solver::gauss_seidel;
  settings.correction = Correction::none;
  settings.is_swept = is_swept;
  return settings;
}

std::vector<double> cooling(const GasRun& run, double restitution, const std::vector<double>& times) {
  Scene scene = equilibrium_gas(run.cells, run.rho, run.seed);
  scene.physics.restitution = restitution;
  const double tau = cooling_time(run.rho, count_of(run), restitution);
  Settings settings = exact_motion(tau / 100);
  std::vector<double> parts;
  const auto world = make_cpu_world(scene, settings);
  const double start = world->report().kinetic_energy;
  for (const double time : times) {
    step_until(*world, time * tau, settings.dt);
    parts.push_back(world->report().kinetic_energy / start);
  }
  return parts;
}

}  // namespace ballpit
