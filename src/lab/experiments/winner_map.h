// SPDX-License-Identifier: MIT
// A map of the fastest broad phase over the number of spheres and one more parameter. A method wins only if it is
// faster in nearly all turns.
#pragma once

#include "lab/measure/searches.h"
#include "lab/report/experiment.h"

namespace ballpit {

struct WinnerPlan {
  std::string title;      ///< of the map
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

std::vector<double> winner_counts(bool is_quick);  ///< numbers of spheres
int64_t winner_measurements(const WinnerPlan& plan);

std::vector<WinnerCell> find_winners(Lab& lab, const WinnerPlan& plan);

/// The fastest by median, or kTie if it loses more than one turn in nine to the second: a sign test with a significance
/// of 2 %, which other load on the machine does not affect, since it slows both methods of a turn.
int winner_among(const std::vector<SearchTiming>& timings);

/// The table of all searches, the map, a chart of the time of a search against the parameter, for the most spheres, and
/// how often each method wins, in `values`.
Findings winner_findings(const WinnerPlan& plan, const std::vector<WinnerCell>& cells);

/// A series for each method: its cells with the most spheres, against the parameter.
std::vector<Series> series_of(const WinnerPlan& plan, const std::vector<WinnerCell>& cells,
                              const std::function<Point(const WinnerCell&, const SearchTiming&)>& to_point);

/// The median time [s] of a method in a cell; infinite if it was not tried.
double median_of(const WinnerCell& cell, std::string_view broad_phase);

/// For each method its largest time over that of the fastest, in the order of broad_phases().
std::vector<double> worst_losses(const std::vector<WinnerCell>& cells);

}  // namespace ballpit
