// SPDX-License-Identifier: MIT
#include "lab/experiments/long_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "lab/measure/made_scenes.h"

namespace ballpit {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kStepsBetween = 20;  // checks

double energy_of(const Report& report) {
  return report.kinetic_energy + report.potential_energy + report.elastic_energy;
}

}  // namespace

std::vector<LargestDrift> drift_of(const Scene& scene, const Settings& settings, const std::vector<double>& times) {
  std::vector<LargestDrift> drifts;
  const auto world = make_cpu_world(scene, settings);
  const Report start = world->report();
  double moving = 0;
  for (size_t i = 0; i < scene.bodies.mass.size(); ++i) {
    moving += scene.bodies.mass[i] * length(scene.bodies.velocity[i]);
  }
  LargestDrift drift;
  try {
    for (const double time : times) {
      while (world->time() < time - settings.dt / 2) {
        step_until(*world, std::min(time, world->time() + kStepsBetween * settings.dt), settings.dt);
        const Report now = world->report();
        drift.energy = std::max(drift.energy, std::fabs(energy_of(now) / energy_of(start) - 1));
        drift.momentum = std::max(drift.momentum, length(now.momentum - start.momentum) / moving);
      }
      drifts.push_back(drift);
    }
  } catch (const RunError&) {
    drifts.resize(times.size(), {kInfinite, kInfinite});
  }
  return drifts;
}

std::vector<double> oscillator_drift(const std::string& integrator, double omega_dt, int count) {
  constexpr double kStiffness = 1e4, kGravity = 10,
                   kAmplitude = 1e-4;  // ω = 100/s; at rest the overlap with the floor is 1 mm
  constexpr double kRest = -10 + 0.5 - kGravity / kStiffness;
  Scene scene = wide_box(10);
  scene.physics.gravity = {0, -kGravity, 0};
  scene.physics.stiffness = kStiffness;
  add_sphere(scene, {0, kRest + kAmplitude, 0}, Vec3d(0.0), 0.5, 1.0);
  const auto world = make_cpu_world(scene, settings_of("penalty", omega_dt / 100, integrator));
  const double start = 0.5 * kStiffness * kAmplitude * kAmplitude;
  std::vector<double> drifts;
  double largest = 0;
  for (int k = 0; k < count; ++k) {
    while (world->steps() < (int64_t{1} << k)) {
      world->step();
      const Bodies bodies = world->bodies();
      const double y = bodies.position[0].y - kRest, v = bodies.velocity[0].y;
      largest = std::max(largest, std::fabs((0.5 * v * v + 0.5 * kStiffness * y * y) / start - 1));
    }
    drifts.push_back(largest);
  }
  return drifts;
}

double oscillator_theory(const std::string& integrator, double omega_dt, double steps) {
  const double z = omega_dt;
  if (integrator == "explicit-euler") return std::pow(1 + z * z, steps) - 1;
  if (integrator == "velocity-verlet") return z * z / 4;
  if (integrator == "symplectic-euler") return z / (2 - z);
  return 1 - std::pow(1 - std::pow(z, 6) / 72 + std::pow(z, 8) / 576, steps);
}

}  // namespace ballpit
