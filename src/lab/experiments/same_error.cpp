// SPDX-License-Identifier: MIT
#include "lab/experiments/same_error.h"

#include <cmath>

#include "core/error.h"
#include "lab/charts/chart.h"
#include "lab/charts/table.h"
#include "lab/experiments/contact_methods.h"
#include "lab/experiments/hard_spheres.h"
#include "lab/measure/made_scenes.h"
#include "lab/measure/theory.h"

namespace ballpit {

namespace {

constexpr double kContactSteps = 20;  // of springs

Settings stepping(Settings settings) {
  settings.broadphase = BroadPhase::automatic;  // with a candidate list, which suits short steps
  return settings;
}

PressureError error_at(Lab& lab, const Contender& who, double dt) {
  const GasRun run{4, kSameErrorDensity, lab.seed(), lab.is_quick() ? 20 : 60, 15};
  const std::vector<double> z = lab.measure(key_of("Z", who.label, dt, run.seed, run.blocks), [&] {
    try {
      return block_z(run, who.settings(dt), with_springs(equilibrium_gas(run.cells, kSameErrorDensity, run.seed), dt));
    } catch (const RunError&) {
      return std::vector<double>{kNoNumber, kNoNumber};
    }
  });
  const double expected = finite_z(kSameErrorDensity, count_of(run));
  const Mean mean = mean_of(z);
  return {dt, {mean.value / expected - 1, mean.error / expected}};
}

bool holds(const PressureError& error) { return std::fabs(error.off.value) <= kPressureTolerance; }

}  // namespace

const std::vector<Contender>& contenders() {
  static const std::vector<Contender> table{
      {"event-driven", "event-driven", false, [](double dt) { return exact_motion(dt); }},
      {"impulse", "impulse", false, [](double dt) { return stepping(elastic_impulses(dt, false)); }},
      {"impulse, swept", "impulse", true, [](double dt) { return stepping(elastic_impulses(dt, true)); }},
      {"penalty", "penalty", false, [](double dt) { return stepping(settings_of("penalty", dt)); }},
      {"kinematic", "kinematic", false, [](double dt) { return stepping(settings_of("kinematic", dt)); }},
  };
  return table;
}

bool is_exact(const Contender& who) { return who.role == "event-driven"; }

Scene with_springs(Scene gas, double dt) {
  gas.physics.stiffness = stiffness_for(dt, kContactSteps, 0.5, 1);
  return gas;
}

std::vector<PressureError> pressure_errors(Lab& lab, const Contender& who) {
  std::vector<PressureError> errors;
  for (int k = 0; k < kStepsTried; ++k) {
    errors.push_back(error_at(lab, who, kCoarsestStep * std::exp2(-k)));
    if (k > 0 && holds(errors.back()) && holds(errors[errors.size() - 2])) break;
  }
  return errors;
}

double largest_step(const std::vector<PressureError>& errors) {
  const bool is_found = errors.size() > 1 && holds(errors.back()) && holds(errors[errors.size() - 2]);
  return is_found ? errors[errors.size() - 2].dt : 0;
}

}  // namespace ballpit
