// SPDX-License-Identifier: MIT
// The table of experiments: command line, `list`, tests and documents are fed from it. A file each, in experiments/.
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
  std::string answer;  ///< one sentence with its number, made of the data
  std::string see;     ///< a paragraph: what to see in the charts, and what was measured how
};

struct Experiment {
  std::string_view name;                   ///< as on the command line
  std::string_view title;                  ///< as the audience reads it
  std::string_view question;               ///< that it answers
  double quick_seconds;                    ///< [s] on two cores, about
  double full_seconds;                     ///< [s]
  int64_t (*measurements)(bool is_quick);  ///< that it asks its laboratory for, at most
  Findings (*run)(Lab& lab);
};

/// All, in the order in which they tell their story.
const std::vector<Experiment>& experiments();

/// Throws UserError that lists all.
const Experiment& find_experiment(std::string_view name);

}  // namespace ballpit
