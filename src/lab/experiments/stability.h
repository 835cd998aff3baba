// SPDX-License-Identifier: MIT
// The maps of `stability`: where a method works and where it fails, over two of its parameters, with the formula of the
// line between.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lab/charts/chart.h"
#include "lab/measure/boundary.h"
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
  std::string label;    ///< of what is measured
  double low, high;     ///< values of the first and the last colour
  bool is_log;          ///< colours follow the logarithm
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

MapBoundary boundary_of(const FailureMap& which, const Map& map);

}  // namespace ballpit
