// SPDX-License-Identifier: MIT
// Spheres of different sizes: the cells of a single grid must fit the largest, and then hold many small ones.
#include "lab/experiments/experiments.h"
#include "lab/experiments/winner_map.h"

namespace ballpit {

namespace {

WinnerPlan plan_of(bool is_quick) {
  WinnerPlan plan{
      "Fastest broad phase, spheres of different sizes",
      "size ratio",
      Axis{"largest over smallest radius", "", Scale::log},
      is_quick ? std::vector<double>{1, 2, 4, 8, 16} : std::vector<double>{1, 1.4, 2, 2.8, 4, 5.6, 8, 11, 16, 22, 32},
      winner_counts(is_quick),
      [](int64_t count, double ratio, uint64_t seed) {
        return uniform_spheres({count, 0.3, ratio}, seed);
      }};
  if (!is_quick) plan.counts.pop_back();  // a million spheres in a single grid take longer than all other cases
  return plan;
}

int64_t measurements(bool is_quick) { return winner_measurements(plan_of(is_quick)); }

Findings measure(Lab& lab) {
  const WinnerPlan plan = plan_of(lab.is_quick());
  const std::vector<WinnerCell> cells = find_winners(lab, plan);
  Findings findings = winner_findings(plan, cells);
  const auto candidates = [](const WinnerCell& cell, const SearchTiming& timing) {
    return Point{cell.value, timing.candidates / cell.count};
  };
  const std::string count = grouped(static_cast<int64_t>(plan.counts.back()));
  findings.charts.push_back({"candidates", phrase("Candidates a sphere, {} spheres", count), plan.axis,
                             Axis{"candidates a sphere", "", Scale::log}, series_of(plan, cells, candidates)});
  const WinnerCell& last = cells.back();  // most spheres, largest ratio
  const double times = median_of(last, "linked-cell") / median_of(last, "sorted-grid");
  findings.values.insert({{"ratio", number_text(last.value)}, {"spheres", count}, {"times", three_digits(times)}});
  return findings;
}

}  // namespace

Experiment size_ratio_experiment() { return {"size-ratio", 20, 650, measurements, measure}; }

}  // namespace ballpit
