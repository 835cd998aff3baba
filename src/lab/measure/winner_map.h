// SPDX-License-Identifier: MIT
// Which broad phase is fastest, over the number of spheres and one more parameter: a map of the winner, where a lead that
// not nearly all turns show counts as none.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/charts/chart.h"
#include "lab/charts/table.h"
#include "lab/measure/lab.h"
#include "lab/measure/search_timing.h"

namespace ballpit {

struct WinnerPlan {
  std::string parameter;  ///< "aspect": in keys and tables
  Axis axis;              ///< of the parameter, upwards in the chart
  std::vector<double> values;
  std::vector<double> counts;  ///< of spheres
  std::function<SphereSet(int64_t count, double value, uint64_t seed)> make_spheres;
};

/// All methods at one count and value.
struct WinnerCell {
  double count, value;
  std::vector<SearchTiming> timings;  ///< in the order of broad_phases(); without seconds where it was not tried
  int winner;                         ///< among them; kTie where the two fastest are too close to tell
};

inline constexpr int kTie = -1;

/// Beyond so many spheres brute force is not tried: it makes n²/2 tests, and lost long before.
inline constexpr double kMostForBruteForce = 30'000;

/// Numbers of spheres, and measurements.
std::vector<double> winner_counts(bool is_quick);
int64_t winner_measurements(const WinnerPlan& plan);

std::vector<WinnerCell> find_winners(Lab& lab, const WinnerPlan& plan);

/// The fastest by median, or kTie where it loses more than one turn in nine to the next: a sign test, at 2 % of chance, that what
/// else the machine does cannot sway, since it falls on both in a turn.
int winner_among(const std::vector<SearchTiming>& timings);

Chart winner_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells, const std::string& title);

/// The time of a search against the parameter, for the most spheres, method by method.
Chart time_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells);

Table winner_table(const WinnerPlan& plan, const std::vector<WinnerCell>& cells);

/// "Sorted grid is fastest in 20 of 30 cases, linked cell in 5, and 5 are too close to tell"
std::string tally_of(const std::vector<WinnerCell>& cells);

/// How cells of the map are won, in words.
std::string winning_rule();

/// Of each method that was tried: its time over the winner's where it loses most. In the order of broad_phases().
std::vector<double> worst_losses(const std::vector<WinnerCell>& cells);

}  // namespace ballpit
