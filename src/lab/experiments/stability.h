// SPDX-License-Identifier: MIT
// The maps of `stability`: where a method works and where it fails, over two of its parameters, with the formula of the
// line between.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/charts/chart.h"
#include "lab/measure/lab.h"

namespace ballpit {

/// The cells along one axis of a quick run; a full run has twice as many.
struct MapAxis {
  Axis axis;
  double low, high;  ///< centres of the first and the last cell
  int cells;
};

struct FailureMap {
  std::string name;   ///< the chart's file: "springs"
  std::string title;  ///< a sentence
  MapAxis x, y;
  Axis colors;          ///< of what is measured
  std::string formula;  ///< label of the line
  std::string where;    ///< what changes at the line
  /// Measures a column: a value for each y.
  std::vector<double> (*column)(double x, const std::vector<double>& y, uint64_t seed);
  bool (*has_crossed)(double value);
  double (*theory)(double x);  ///< the y of the line
};

const std::vector<FailureMap>& failure_maps();

/// One measurement per column.
Map measure_map(Lab& lab, const FailureMap& which);

/// The boundary of a map: in each column the lowest y at which `has_crossed` is true.
struct MapBoundary {
  std::vector<double> y;  ///< half way between two cells; kNoNumber in columns without a crossing
  double distance = 0;    ///< the largest of any column between measurement and theory [cells along y]
  int columns = 0;        ///< with a crossing
};

/// `theory` gives y for x. A y outside the map counts as its edge, and so does a column without a crossing.
MapBoundary find_boundary(const Map& map, Scale y_scale, const std::function<bool(double)>& has_crossed,
                          const std::function<double(double)>& theory);

MapBoundary boundary_of(const FailureMap& which, const Map& map);

}  // namespace ballpit
