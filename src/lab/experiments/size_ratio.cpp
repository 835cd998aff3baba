// SPDX-License-Identifier: MIT
// Spheres of different sizes: one grid must fit the largest, and then holds many small ones in each cell.
#include <algorithm>
#include <utility>

#include "core/numbers.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/winner_map.h"
#include "scene/input_error.h"

namespace ballpit {

namespace {

WinnerPlan plan_of(bool is_quick) {
  WinnerPlan plan;
  plan.parameter = "size ratio";
  plan.axis = {"largest over smallest radius", "", Scale::log};
  plan.values =
      is_quick ? std::vector<double>{1, 2, 4, 8, 16} : std::vector<double>{1, 1.4, 2, 2.8, 4, 5.6, 8, 11, 16, 22, 32};
  plan.counts = winner_counts(is_quick);
  if (!is_quick) plan.counts.pop_back();  // a million small ones in one grid's wide cells take longer than all others
  plan.make_spheres = [](int64_t count, double ratio, uint64_t seed) {
    return uniform_spheres({count, 0.3, ratio}, seed);
  };
  return plan;
}

int64_t measurements(bool is_quick) { return winner_measurements(plan_of(is_quick)); }

/// Candidates a sphere at the largest number of spheres, against the size ratio.
Chart candidates_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells) {
  const double most = plan.counts.back();
  Chart chart{"candidates",
              "Candidates a sphere, " + grouped(static_cast<int64_t>(most)) + " spheres",
              plan.axis,
              {"candidates a sphere", "", Scale::log},
              {}};
  for (size_t k = 0; k < broad_phases().size(); ++k) {
    Series series{label_of(broad_phases()[k]), broad_phases()[k], {}};
    for (const WinnerCell& cell : cells) {
      if (cell.count != most || cell.timings[k].seconds.empty()) continue;
      series.points.push_back({cell.value, cell.timings[k].candidates / cell.count});
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

Findings run(Lab& lab) {
  const WinnerPlan plan = plan_of(lab.is_quick());
  const std::vector<WinnerCell> cells = find_winners(lab, plan);
  const WinnerCell& last = cells.back();  // most spheres, largest ratio
  const auto time = [&](const char* name) {
    const std::vector<std::string> names = broad_phases();
    return last.timings[static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin())]
        .spread()
        .median;
  };
  Findings findings;
  findings.tables = {winner_table(plan, cells)};
  findings.charts = {winner_chart(plan, cells, "Fastest broad phase, spheres of different sizes"),
                     time_chart(plan, cells), candidates_chart(plan, cells)};
  findings.answer = "Of radii 1 : " + number_text(last.value) + ", " + grouped(static_cast<int64_t>(last.count)) +
                    " spheres take the linked cell's single grid " +
                    three_digits(time("linked-cell") / time("sorted-grid")) +
                    " times as long as the sorted grid with its grid for each size class.";
  findings.see =
      "Centres drawn evenly, 30 % of the volume; between the smallest and the largest, the density of radii goes as "
      "r⁻³, so most spheres are small. One grid must have cells as wide as the largest sphere: each then holds many "
      "small ones, and candidates grow with a power of the ratio. Grids for each size class keep them few. Sort and "
      "sweep does not mind sizes as such: an interval is as long as its sphere is wide. " +
      winning_rule() + " " + tally_of(cells) + ".";
  return findings;
}

}  // namespace

Experiment size_ratio_experiment() {
  return {"size-ratio",
          "Spheres of different sizes",
          "Which broad phase is fastest when large spheres lie among small ones?",
          20,
          650,
          measurements,
          run};
}

}  // namespace ballpit
