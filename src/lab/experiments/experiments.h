// SPDX-License-Identifier: MIT
// What the files of the experiments include: charts, tables, texts; the entry of each in the table, defined in the file of
// the same name; and formulas that tests check.
#pragma once

#include <algorithm>

#include <fmt/format.h>

#include "core/numbers.h"
#include "lab/charts/chart_axis.h"
#include "lab/measure/sphere_set.h"
#include "lab/report/experiment.h"

namespace ballpit {

Experiment scaling_experiment();
Experiment cell_size_experiment();
Experiment size_ratio_experiment();
Experiment density_experiment();
Experiment axis_experiment();
Experiment divergence_experiment();
Experiment crossover_experiment();
Experiment cooling_experiment();
Experiment drift_experiment();
Experiment equation_of_state_experiment();
Experiment stability_experiment();
Experiment work_precision_experiment();

/// The expected number of overlapping pairs among `count` intervals of length 1 whose middles are uniform along a
/// length L: n(n−1)/2 · (2/L − 1/L²); all pairs if L is less than 1.
double expected_interval_overlaps(int64_t count, double length);

/// The share of at least one contact that cells of this edge are expected to find in a 3 × 3 × 3 block: the mean over
/// pairs of Π clamp(2 − |d_k|/edge, 0, 1) over the axes k.
double expected_recall(const SphereSet& spheres, const std::vector<Pair>& contacts, double edge);

/// The standard error of a share found among this number of independent pairs.
double recall_error(double recall, size_t contacts);

/// The error of the pressure of a gas at a step.
struct PressureError {
  double dt;
  Mean off;  ///< Z/Z_N − 1; NaN if the run stopped
};

/// The coarser of the last two steps if both are within the tolerance of `crossover`; else 0. Errors are sorted by step,
/// coarsest first.
double largest_step(const std::vector<PressureError>& errors);

}  // namespace ballpit
