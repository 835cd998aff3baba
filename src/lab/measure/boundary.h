// SPDX-License-Identifier: MIT
// The line along which a measured map changes sides, and its distance from the line of theory.
#pragma once

#include <functional>
#include <vector>

#include "lab/charts/chart.h"

namespace ballpit {

/// The boundary of a map: in each column the lowest y at which `has_crossed` is true.
struct MapBoundary {
  std::vector<double> y;  ///< half way between two cells; kNoNumber in columns without a crossing
  double distance = 0;    ///< the largest of any column between measurement and theory [cells along y]
  int columns = 0;        ///< with a crossing
};

/// `theory` gives y for x. A y outside the map counts as its edge, and so does a column without a crossing.
MapBoundary find_boundary(const Map& map, Scale y_scale, const std::function<bool(double)>& has_crossed,
                          const std::function<double(double)>& theory);

/// `count` numbers from `low` to `high`, both included: at equal distances, or at equal ratios.
std::vector<double> spaced(double low, double high, int count, Scale scale);

}  // namespace ballpit
