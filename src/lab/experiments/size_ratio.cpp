// SPDX-License-Identifier: MIT
// Spheres of different sizes: the cells of a single grid must fit the largest, and then hold many small ones.
#include <algorithm>

#include <fmt/format.h>

#include "core/numbers.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/winner_map.h"
#include "scene/input_error.h"

namespace ballpit {

namespace {

WinnerPlan plan_of(bool is_quick) {
  WinnerPlan plan{
      "size ratio", Axis{"largest over smallest radius", "", Scale::log},
      is_quick ? std::vector<double>{1, 2, 4, 8, 16} : std::vector<double>{1, 1.4, 2, 2.8, 4, 5.6, 8, 11, 16, 22, 32},
      winner_counts(is_quick), [](int64_t count, double ratio, uint64_t seed) {
        return uniform_spheres({count, 0.3, ratio}, seed);
      }};
  if (!is_quick) plan.counts.pop_back();  // a million spheres in a single grid take longer than all other cases
  return plan;
}

int64_t measurements(bool is_quick) { return winner_measurements(plan_of(is_quick)); }

Chart candidates_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells) {
  return {"candidates",
          fmt::format("Candidates a sphere, {} spheres", grouped(static_cast<int64_t>(plan.counts.back()))), plan.axis,
          Axis{"candidates a sphere", "", Scale::log},
          series_of(plan, cells, [](const WinnerCell& cell, const SearchTiming& timing) {
            return Point{cell.value, timing.candidates / cell.count};
          })};
}

Findings run(Lab& lab) {
  const WinnerPlan plan = plan_of(lab.is_quick());
  const std::vector<WinnerCell> cells = find_winners(lab, plan);
  const WinnerCell& last = cells.back();  // most spheres, largest ratio
  const auto time = [&](const char* name) {
    const std::vector<std::string> names = broad_phases();
    const auto method = std::find(names.begin(), names.end(), name) - names.begin();
    return last.timings[static_cast<size_t>(method)].spread().median;
  };
  return {
      {winner_table(plan, cells)},
      {winner_chart(plan, cells, "Fastest broad phase, spheres of different sizes"), time_chart(plan, cells),
       candidates_chart(plan, cells)},
      fmt::format("Of radii 1 : {}, {} spheres take the linked cell's single grid {} times as long as the sorted "
                  "grid with its grid for each size class.",
                  number_text(last.value), grouped(static_cast<int64_t>(last.count)),
                  three_digits(time("linked-cell") / time("sorted-grid"))),
      fmt::format("Uniform centres, 30 % of the volume; the density of radii is proportional to r⁻³, so most spheres "
                  "are small. A single grid needs cells as wide as the largest sphere. Each then holds many small "
                  "spheres, and the number of candidates grows with a power of the ratio. A grid for each size class "
                  "avoids that. Sort and sweep does not depend on the sizes directly: an interval is as long as its "
                  "sphere is wide. {} {}.",
                  winning_rule(), tally_of(cells))};
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
