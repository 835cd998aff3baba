// SPDX-License-Identifier: MIT
// Each experiment's entry in the table; the file of that name has the rest.
#pragma once

#include "lab/experiment.h"

namespace ballpit {

Experiment divergence_experiment();
Experiment cooling_experiment();
Experiment drift_experiment();
Experiment equation_of_state_experiment();
Experiment stability_experiment();
Experiment work_precision_experiment();

}  // namespace ballpit
