// SPDX-License-Identifier: MIT
// From a thin gas to a dense heap: which broad phase is fastest at which density.
#include <algorithm>
#include <utility>

#include "core/numbers.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/winner_map.h"

namespace ballpit {

namespace {

WinnerPlan plan_of(bool is_quick) {
  WinnerPlan plan;
  plan.parameter = "volume fraction";
  plan.axis = {"volume of the spheres over that of the box", "", Scale::log};
  plan.values = is_quick ? std::vector<double>{0.001, 0.01, 0.1, 0.5}
                         : std::vector<double>{0.0001, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.2, 0.4, 0.8};
  plan.counts = winner_counts(is_quick);
  plan.make_spheres = [](int64_t count, double fraction, uint64_t seed) {
    return uniform_spheres({count, fraction}, seed);
  };
  return plan;
}

int64_t measurements(bool is_quick) { return winner_measurements(plan_of(is_quick)); }

Findings run(Lab& lab) {
  const WinnerPlan plan = plan_of(lab.is_quick());
  const std::vector<WinnerCell> cells = find_winners(lab, plan);
  const std::vector<double> losses = worst_losses(cells);
  const auto safest = static_cast<size_t>(std::min_element(losses.begin() + 1, losses.end()) - losses.begin());
  Findings findings;
  findings.tables = {winner_table(plan, cells)};
  findings.charts = {winner_chart(plan, cells, "Fastest broad phase by density"), time_chart(plan, cells)};
  findings.answer = tally_of(cells) + "; whoever always takes the " + label_of(broad_phases()[safest]) +
                    " needs at worst " + three_digits(losses[safest]) + " times the time of the fastest.";
  findings.see =
      "Equal spheres, centres drawn evenly. Few spheres: what a structure costs is more than what it saves, and "
      "brute force's plain loop wins. Many: cells win, whatever the density. Thin gases have many empty cells, which "
      "cost time to clear; dense heaps have many real contacts, which every method must find. " +
      winning_rule();
  return findings;
}

}  // namespace

Experiment density_experiment() {
  return {"density",    "Density", "Which broad phase is fastest in a thin gas, and which in a dense heap?", 12, 420,
          measurements, run};
}

}  // namespace ballpit
