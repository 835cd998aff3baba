// SPDX-License-Identifier: MIT
// The maps of `stability`: over two parameters of a method, where it holds and where it fails, with the formula of the line
// between.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lab/charts/chart.h"
#include "lab/measure/boundary.h"
#include "lab/measure/lab.h"

namespace ballpit {

/// The cells along one axis, in a quick run; a full run has twice as many.
struct MapAxis {
  Axis axis;
  double low, high;  ///< the first and the last cell's centre
  int cells;
};

struct FailureMap {
  std::string name;   ///< the chart's file: "springs"
  std::string title;  ///< a sentence
  MapAxis x, y;
  std::string label;                                                                     ///< of what is measured
  double low, high;                                                                      ///< of its colours
  bool is_log;                                                                           ///< as the colours go
  std::string formula;                                                                   ///< beside its line
  std::string where;                                                                     ///< what changes at the line
  std::vector<double> (*column)(double x, const std::vector<double>& y, uint64_t seed);  ///< a value for each y
  bool (*has_crossed)(double value);
  double (*theory)(double x);  ///< the y of the line
};

const std::vector<FailureMap>& failure_maps();

/// One measurement a column.
Map measure_map(Lab& lab, const FailureMap& which);

MapBoundary boundary_of(const FailureMap& which, const Map& map);

}  // namespace ballpit
