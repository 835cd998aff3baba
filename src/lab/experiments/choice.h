// SPDX-License-Identifier: MIT
// What is made of judged choices: their tables and charts.
#pragma once

#include "lab/measure/regret.h"
#include "lab/report/experiment.h"

namespace ballpit {

struct JudgedScene {
  uint64_t seed;
  Judged judged;

  bool is_broken() const { return judged.has_choice && !judged.holds; }
  bool is_refused() const { return !judged.has_choice; }
  bool is_missed() const { return is_refused() && judged.has_valid; }  ///< something holds, and was not found
  bool has_regret() const { return judged.has_choice && judged.holds; }
};

Findings choice_findings(const std::vector<JudgedScene>& all);

}  // namespace ballpit
