// SPDX-License-Identifier: MIT
// The table of maps of `stability`.
#include <algorithm>
#include <cmath>

#include "lab/experiments/failures.h"
#include "lab/experiments/stability.h"
#include "lab/measure/theory.h"

namespace ballpit {

namespace {

using Values = std::vector<double>;

template <class Cell>
Values each(const Values& y, const Cell& cell) {
  Values values;
  for (const double at : y) values.push_back(cell(at));
  return values;
}

Values springs(double dt, const Values& stiffness, uint64_t) {
  return each(stiffness, [dt](double k) { return spring_growth(dt, k); });
}

Values tunnelling(double step, const Values& impact, uint64_t) {
  return each(impact, [step](double b) { return part_of_hits_seen(step, b, 800); });
}

/// The part of searches with at least this recall. Searches with the same cells differ by the places of the pairs.
Values cells(double edge, const Values& recall, uint64_t seed) {
  constexpr int kSearches = 40, kPairs = 1000;
  Values found;
  for (uint64_t k = 0; k < kSearches; ++k) found.push_back(recall_of_cells(edge, kPairs, seed * 1000 + k));
  return each(recall, [&found](double least) {
    return static_cast<double>(
               std::count_if(found.begin(), found.end(), [least](double part) { return part >= least; })) /
           kSearches;
  });
}

int whole(double sweeps) { return static_cast<int>(std::lround(sweeps)); }

Values tall_stack(double n, const Values& sweeps, uint64_t) {
  const Values masses(static_cast<size_t>(std::lround(n)), 1.0);
  return each(sweeps, [&](double count) { return speed_left(masses, whole(count)); });
}

Values heavy_stack(double ratio, const Values& sweeps, uint64_t) {
  return each(sweeps, [&](double count) { return speed_left({1.0, ratio}, whole(count)); });
}

Values far_out(double x, const Values& step, uint64_t) {
  return each(step, [x](double way) { return part_of_way(x, way); });
}

double largest_stiffness(double dt) { return 0.5 / (dt * dt); }  // dt = √(m/(2k)), twelve contacts each; m = 1
double largest_impact(double step) { return step < 2 ? std::sqrt(1 - step * step / 4) : 0; }

bool is_unstable(double growth) { return growth > kStableGrowth; }
bool is_below_one(double part) { return part < 1; }
bool is_below_half(double part) { return part < 0.5; }
bool is_below_percent(double left) { return left < 0.01; }
bool has_moved(double part) { return part > 0; }

}  // namespace

const std::vector<FailureMap>& failure_maps() {
  const Axis sweeps{"sweeps of Gauss–Seidel", "", Scale::log}, left{"speed left", "", Scale::log, 1e-4, 1};
  static const std::vector<FailureMap> table{
      {"springs", "Springs explode where the step is too large for their stiffness",
       MapAxis{Axis{"step dt", "s", Scale::log}, 1e-4, 1e-2, 17},
       MapAxis{Axis{"stiffness k", "N/m", Scale::log}, 1e3, 1e8, 21}, Axis{"growth a step", "", Scale::log, 1, 3},
       "k = m/(2·dt²)", "a packing with twelve contacts each begins to grow", springs, is_unstable, largest_stiffness},
      {"tunnelling", "Where a step is longer than the chord, hits go unseen", MapAxis{{"step v·dt/D"}, 0.1, 3.9, 20},
       MapAxis{{"impact parameter b/D"}, 0.03125, 0.96875, 16}, Axis{"part of hits seen", "", Scale::linear, 0, 1},
       "2√(1 − b²/D²)", "the first hit is missed", tunnelling, is_below_one, largest_impact},
      {"cell-size", "Cells smaller than a diameter lose contacts", MapAxis{{"cell edge c/D"}, 0.4, 1.1, 15},
       MapAxis{{"recall: contacts found"}, 0.025, 0.975, 20}, Axis{"part of searches", "", Scale::linear, 0, 1},
       "⟨∏ (2 − |d|/c)⟩", "half of the searches find less", cells, is_below_half, cell_recall},
      {"tall-stack", "A stack twice as tall needs four times the sweeps",
       MapAxis{{"spheres n in the stack"}, 4, 40, 10}, MapAxis{sweeps, 8, 4096, 19}, left, "1.866·n²",
       "a percent of the error is left", tall_stack, is_below_percent, stack_sweeps},
      {"mass-ratio", "A load R times as heavy needs R times the sweeps",
       MapAxis{Axis{"mass ratio R", "", Scale::log}, 1, 1000, 13}, MapAxis{sweeps, 4, 8192, 23}, left,
       "ln 100/ln(1+1/R)", "a percent of the error is left", heavy_stack, is_below_percent, ratio_sweeps},
      {"far-out", "Far from the origin, single precision stands still",
       MapAxis{Axis{"place x", "m", Scale::log}, 96, 6291456, 17},
       MapAxis{Axis{"step v·dt", "m", Scale::log}, 1e-6, 1, 19}, Axis{"way made", "", Scale::linear, 0, 2}, "ulp(x)/2",
       "a sphere in single precision begins to move", far_out, has_moved, frozen_step},
  };
  return table;
}

}  // namespace ballpit
