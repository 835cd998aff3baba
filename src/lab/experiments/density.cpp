// SPDX-License-Identifier: MIT
// The fastest broad phase for each density, from a thin gas to a dense heap.
#include <algorithm>

#include <fmt/format.h>

#include "core/numbers.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/winner_map.h"

namespace ballpit {

namespace {

WinnerPlan plan_of(bool is_quick) {
  return {"volume fraction", Axis{"volume of the spheres over that of the box", "", Scale::log},
          is_quick ? std::vector<double>{0.001, 0.01, 0.1, 0.5}
                   : std::vector<double>{0.0001, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.2, 0.4, 0.8},
          winner_counts(is_quick), [](int64_t count, double fraction, uint64_t seed) {
            return uniform_spheres({count, fraction}, seed);
          }};
}

int64_t measurements(bool is_quick) { return winner_measurements(plan_of(is_quick)); }

Findings run(Lab& lab) {
  const WinnerPlan plan = plan_of(lab.is_quick());
  const std::vector<WinnerCell> cells = find_winners(lab, plan);
  const std::vector<double> losses = worst_losses(cells);
  const auto safest = static_cast<size_t>(std::min_element(losses.begin() + 1, losses.end()) - losses.begin());
  return {{winner_table(plan, cells)},
          {winner_chart(plan, cells, "Fastest broad phase by density"), time_chart(plan, cells)},
          fmt::format("{}; always taking the {} costs at worst {} times the time of the fastest.", tally_of(cells),
                      label_of(broad_phases()[safest]), three_digits(losses[safest])),
          "Equal spheres with uniform centres. With few spheres, a structure costs more than it saves, and "
          "the plain loop of brute force is fastest. With many, cells are fastest at every density. Thin "
          "gases have many empty cells, which take time to clear; dense heaps have many contacts, which "
          "every method must find. " +
              winning_rule()};
}

}  // namespace

Experiment density_experiment() {
  return {"density",    "Density", "Which broad phase is fastest in a thin gas, and which in a dense heap?", 12, 420,
          measurements, run};
}

}  // namespace ballpit
