// SPDX-License-Identifier: MIT
#include "lab/experiments/hard_spheres.h"

#include <algorithm>
#include <cmath>

#include "lab/made_scenes.h"
#include "lab/theory.h"

namespace ballpit {

double count_of(const GasRun& run) { return 4.0 * run.cells * run.cells * run.cells; }

std::vector<double> block_z(const GasRun& run, const Settings& settings) {
  return block_z(run, settings, equilibrium_gas(run.cells, run.rho, run.seed));
}

std::vector<double> block_z(const GasRun& run, const Settings& settings, const Scene& gas) {
  const double count = count_of(run), block = run.collisions / collision_rate(run.rho, count);
  Settings own = settings;
  own.keeps_tally = true;
  const bool is_exact = settings.response == "event-driven";
  if (is_exact) own.dt = block;
  const auto world = make_cpu_world(gas, own);
  std::vector<double> values;
  Report last = world->report();
  for (int k = 1; k <= run.blocks; ++k) {
    step_until(*world, k * block, own.dt);
    const Report now = world->report();
    const double kt = (last.kinetic_energy + now.kinetic_energy) / (3 * (count - 1));
    values.push_back(1 + (now.tally.virial - last.tally.virial) / (3 * count * kt * (now.time - last.time)));
    last = now;
  }
  return values;
}

Settings elastic_impulses(double dt, bool is_swept) {
  Settings settings = settings_of("impulse", dt);
  settings.solver = "gauss-seidel";
  settings.correction = "none";
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
