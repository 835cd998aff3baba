// SPDX-License-Identifier: MIT
// The table of experiments. The command line, `list`, tests and documents use it. Each has a file in experiments/.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lab/charts/chart.h"
#include "lab/charts/table.h"
#include "lab/measure/lab.h"

namespace ballpit {

/// What an experiment found.
struct Findings {
  std::vector<Table> tables;
  std::vector<Chart> charts;
  std::string answer;  ///< one sentence with a number, computed from the data
  std::string see;     ///< a paragraph: what was measured, how, and what the charts show
};

struct Experiment {
  std::string_view name;                   ///< as on the command line
  std::string_view title;                  ///< for the audience
  std::string_view question;               ///< the one that it answers
  double quick_seconds;                    ///< [s] about, on two cores
  double full_seconds;                     ///< [s]
  int64_t (*measurements)(bool is_quick);  ///< the largest number that it asks its laboratory for
  Findings (*run)(Lab& lab);
};

/// In the order of the report.
const std::vector<Experiment>& experiments();

/// Throws UserError that lists all.
const Experiment& find_experiment(std::string_view name);

}  // namespace ballpit
