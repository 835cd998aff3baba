// SPDX-License-Identifier: MIT
// The entry of each experiment in the table, defined in the file of the same name, and formulas that tests check.
#pragma once

#include <cstdint>
#include <vector>

#include "bodies/pair.h"
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

}  // namespace ballpit
