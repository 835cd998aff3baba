// SPDX-License-Identifier: MIT
// A map of the fastest broad phase over the number of spheres and one more parameter. A method wins only if it is
// faster in nearly all turns.
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
  std::string parameter;  ///< "aspect", in keys
  Axis axis;              ///< of the parameter, which is y in the map
  std::vector<double> values;
  std::vector<double> counts;  ///< of spheres
  std::function<SphereSet(int64_t count, double value, uint64_t seed)> make_spheres;
};

/// All methods for one count and value.
struct WinnerCell {
  double count, value;
  std::vector<SearchTiming> timings;  ///< in the order of broad_phases(); without seconds if not tried
  int winner;                         ///< index of the fastest; kTie if the two fastest are too close
};

inline constexpr int kTie = -1;

/// Brute force is not tried with more spheres: it makes n²/2 tests, and is slowest long before.
inline constexpr double kMaxForBruteForce = 30'000;

std::vector<double> winner_counts(bool is_quick);  ///< numbers of spheres
int64_t winner_measurements(const WinnerPlan& plan);

std::vector<WinnerCell> find_winners(Lab& lab, const WinnerPlan& plan);

/// The fastest by median, or kTie if it loses more than one turn in nine to the second: a sign test with a significance
/// of 2 %, which other load on the machine does not affect, since it slows both methods of a turn.
int winner_among(const std::vector<SearchTiming>& timings);

Chart winner_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells, const std::string& title);

/// A series for each method: its cells with the most spheres, against the parameter.
std::vector<Series> series_of(const WinnerPlan& plan, const std::vector<WinnerCell>& cells,
                              const std::function<Point(const WinnerCell&, const SearchTiming&)>& to_point);

/// The time of a search against the parameter, for the most spheres.
Chart time_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells);

Table winner_table(const WinnerPlan& plan, const std::vector<WinnerCell>& cells);

/// "Sorted grid is fastest in 20 of 30 cases, linked cell in 5, and 5 are too close to tell"
std::string tally_of(const std::vector<WinnerCell>& cells);

/// How the map was measured, as text.
std::string winning_rule();

/// For each method its largest time over that of the fastest, in the order of broad_phases().
std::vector<double> worst_losses(const std::vector<WinnerCell>& cells);

}  // namespace ballpit
