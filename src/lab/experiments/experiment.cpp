// SPDX-License-Identifier: MIT
#include "lab/report/experiment.h"

#include <sstream>

#include <fmt/args.h>

#include "core/error.h"
#include "core/language.h"
#include "lab/experiments/experiments.h"
#include "lab_texts.h"

namespace ballpit {

std::vector<std::string> paragraphs_of(std::string_view name) {
  std::vector<std::string> paragraphs(1);
  const std::string file = std::string(name) + (language() == Language::german ? ".de.md" : ".md");
  std::istringstream lines(std::string(entry_named(lab_texts(), file, "assets/lab").text));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# ") || line.starts_with("> ")) line.erase(0, 2);
    std::string& last = paragraphs.back();
    if (line.empty()) {
      paragraphs.emplace_back();
    } else {
      last += (last.empty() ? "" : " ") + line;
    }
  }
  return paragraphs;
}

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> table{
      scaling_experiment(),
      cell_size_experiment(),
      density_experiment(),
      size_ratio_experiment(),
      axis_experiment(),
      divergence_experiment(),
      tuning_experiment(),
      work_precision_experiment(),
      crossover_experiment(),
      stability_experiment(),
      equation_of_state_experiment(),
      cooling_experiment(),
      drift_experiment(),
      pi_experiment(),
      substeps_experiment(),
      far_origin_experiment(),
      choice_experiment(),
  };
  return table;
}

ExperimentText Experiment::text() const {
  const std::vector<std::string> paragraphs = paragraphs_of(name);
  return {paragraphs.at(0), paragraphs.at(1), paragraphs.at(2), paragraphs.at(3)};
}

Findings Experiment::run(Lab& lab) const {
  Findings findings = measure(lab);
  const ExperimentText text = this->text();
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (const auto& [key, value] : findings.values) values.push_back(fmt::arg(key.c_str(), local_number(value)));
  if (findings.answer.empty()) findings.answer = fmt::vformat(text.answer, values);
  findings.see = fmt::vformat(text.see, values);
  return findings;
}

const Experiment& find_experiment(std::string_view name) {
  const auto& all = experiments();
  const auto found = std::ranges::find(all, name, &Experiment::name);
  if (found != all.end()) return *found;
  std::vector<std::string_view> names;
  for (const Experiment& experiment : all) names.push_back(experiment.name);
  throw UserError("EXPERIMENT", name, "all, " + join(names));
}

}  // namespace ballpit
