// SPDX-License-Identifier: MIT
// Where a measured map changes sides, and how far that is from where theory says.
#pragma once

#include <functional>
#include <vector>

#include "lab/charts/chart.h"

namespace ballpit {

/// A map's boundary: in each column the y at which `has_crossed` first comes true from below.
struct MapBoundary {
  std::vector<double> y;  ///< half way between two cells; kNoNumber in a column that does not cross
  double distance = 0;    ///< the largest in any column from measured to theory, in cells along y
  int columns = 0;        ///< that cross
};

/// `theory` gives y for x; outside the map it counts as the map's edge, as does a column that does not cross.
MapBoundary find_boundary(const Map& map, Scale y_scale, const std::function<bool(double)>& has_crossed,
                          const std::function<double(double)>& theory);

/// `count` centres from `low` to `high`, both included: evenly spaced, or by equal factors.
std::vector<double> spaced(double low, double high, int count, Scale scale);

}  // namespace ballpit
