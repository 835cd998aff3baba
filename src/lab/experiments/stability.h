// SPDX-License-Identifier: MIT
// The maps of `stability`: where a method works and where it fails, over two of its parameters, with the formula of the
// line between.
#pragma once

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
  std::function<std::vector<double>(double x, const std::vector<double>& y, uint64_t seed)> column;
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

// The measurements behind the maps: each function gives the value of one cell. Their formulas are in
// measure/theory.h.

/// The factor by which the fastest motion grows in a step of velocity Verlet: an fcc crystal of 108 spheres (diameter 1
/// m, mass 1 kg), slightly compressed and slightly displaced. At most 1.02 if it is stable.
double spring_growth(double dt, double stiffness);
inline constexpr double kStableGrowth = 1.02;

/// The part of hits that contacts at the ends of steps of s diameters (or swept contacts) find at the impact parameter
/// b/D: `phases` pairs, each hit at a different moment of a step.
double part_of_hits_seen(double step, double impact, int phases, bool is_swept = false);

/// The part of `pairs` touching pairs with random places and directions that linked cells of this edge [diameters]
/// find.
double recall_of_cells(double edge, int pairs, uint64_t seed);

/// The largest speed that this number of Gauss–Seidel sweeps leaves in a step, as a part of the speed that gravity
/// adds, for spheres of these masses at rest one on top of the other.
double speed_left(const std::vector<double>& masses, int sweeps);

/// The way of a sphere at x [m] in single precision with v·dt [m] per step, as a part of the exact way.
double part_of_way(double x, double step);

/// Whether a bullet that moves `step` [m] in a step passes through a wall of spheres 0.2 m thick.
bool passes_through(double step, bool is_swept);

}  // namespace ballpit
