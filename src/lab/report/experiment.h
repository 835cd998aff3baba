// SPDX-License-Identifier: MIT
// The table of experiments. The command line, `list`, tests and documents use it. Each has a file in experiments/, and
// its text in assets/lab/NAME.md, or NAME.de.md: "# title", the question, "> answer", and a paragraph about what the
// charts show.
#pragma once

#include "lab/charts/chart.h"
#include "lab/charts/table.h"
#include "lab/measure/lab.h"

namespace ballpit {

/// What an experiment found.
struct Findings {
  std::vector<Table> tables;
  std::vector<Chart> charts;
  std::map<std::string, std::string> values;  ///< fill the {name} of the text
  std::string answer = {};                    ///< one sentence with a number, computed from the data
  std::string see = {};                       ///< a paragraph: what was measured, how, and what the charts show
};

/// With {name} for values.
struct ExperimentText {
  std::string title, question, answer, see;
};

struct Experiment {
  std::string_view name;                   ///< as on the command line
  double quick_seconds;                    ///< [s] about, on two cores
  double full_seconds;                     ///< [s]
  int64_t (*measurements)(bool is_quick);  ///< the largest number that it asks its laboratory for
  Findings (*measure)(Lab& lab);           ///< without the text, unless the answer is another one

  /// In the language set.
  ExperimentText text() const;

  /// Measures, and fills the text.
  Findings run(Lab& lab) const;
};

/// In the order of the report.
const std::vector<Experiment>& experiments();

/// Throws UserError that lists all.
const Experiment& find_experiment(std::string_view name);

}  // namespace ballpit
