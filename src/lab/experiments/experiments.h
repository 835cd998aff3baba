// SPDX-License-Identifier: MIT
// Each experiment's entry in the table; the file of that name has the rest. Beside them, what tests ask of them.
#pragma once

#include <cstdint>

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

/// Pairs of intervals of length 1 that overlap, of `count` whose middles are drawn evenly along a length:
/// n(n−1)/2 · (2/L − 1/L²), all of them where L is less than 1.
double expected_interval_overlaps(int64_t count, double length);

}  // namespace ballpit
