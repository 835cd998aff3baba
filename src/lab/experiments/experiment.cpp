// SPDX-License-Identifier: MIT
#include "lab/report/experiment.h"

#include "core/error.h"
#include "lab/experiments/experiments.h"

namespace ballpit {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> table{
      scaling_experiment(),   cell_size_experiment(),         density_experiment(),        size_ratio_experiment(),
      axis_experiment(),      divergence_experiment(),        work_precision_experiment(), crossover_experiment(),
      stability_experiment(), equation_of_state_experiment(), cooling_experiment(),        drift_experiment(),
  };
  return table;
}

const Experiment& find_experiment(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Experiment& experiment : experiments()) {
    if (experiment.name == name) return experiment;
    names.push_back(experiment.name);
  }
  throw UserError("EXPERIMENT", name, "all, " + join(names));
}

}  // namespace ballpit
