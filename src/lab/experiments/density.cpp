// SPDX-License-Identifier: MIT
// The fastest broad phase for each density, from a thin gas to a dense heap.

#include "lab/experiments/experiments.h"
#include "lab/experiments/winner_map.h"

namespace ballpit {

namespace {

WinnerPlan plan_of(bool is_quick) {
  return {"Fastest broad phase by density",
          "volume fraction",
          Axis{"volume of the spheres over that of the box", "", Scale::log},
          is_quick ? std::vector<double>{0.001, 0.01, 0.1, 0.5}
                   : std::vector<double>{0.0001, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.2, 0.4, 0.8},
          winner_counts(is_quick),
          [](int64_t count, double fraction, uint64_t seed) {
            return uniform_spheres({count, fraction}, seed);
          }};
}

int64_t measurements(bool is_quick) { return winner_measurements(plan_of(is_quick)); }

Findings measure(Lab& lab) {
  const WinnerPlan plan = plan_of(lab.is_quick());
  const std::vector<WinnerCell> cells = find_winners(lab, plan);
  const std::vector<double> losses = worst_losses(cells);
  const auto safest = static_cast<size_t>(std::min_element(losses.begin() + 1, losses.end()) - losses.begin());
  Findings findings = winner_findings(plan, cells);
  findings.values.insert(
      {{"safest", translated(label_of(broad_phases()[safest]))}, {"loss", three_digits(losses[safest])}});
  return findings;
}

}  // namespace

Experiment density_experiment() { return {"density", 12, 420, measurements, measure}; }

}  // namespace ballpit
