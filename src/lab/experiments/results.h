// SPDX-License-Identifier: MIT
// The results of all methods for a task, with all their steps, repeated in turns; and the Pareto front.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "lab/experiments/accuracy.h"
#include "lab/measure/lab.h"
#include "measure/statistics.h"

namespace ballpit {

/// A method at one step.
struct Result {
  const ContactMethod* method;
  double dt;              ///< [s]
  double error;           ///< infinite if it failed
  double standard_error;  ///< of the repeats
  Spread seconds;         ///< of computation for a simulated second
  bool has_failed() const { return !std::isfinite(error); }
};

bool has_steps(const ContactMethod& method);

/// The methods for a task. In single precision, quick runs use main methods only.
std::vector<const ContactMethod*> methods_of(const Task& task, bool is_quick);

/// For each method of methods_of() all its steps, the coarsest first. Each repeat covers all methods and steps, so that
/// other load on the machine affects all equally.
std::vector<Result> results_of(Lab& lab, const Task& task);

/// The number of measurements for that.
int64_t trial_count(const Task& task, bool is_quick);

/// The typical standard error of the results that did not fail: smaller errors are chance. 0 if nothing is random.
double floor_of(const Task& task, const std::vector<Result>& results);

/// The Pareto front: results that no other beats in both error and time, fastest first. Errors below `floor` and
/// kMinError count as these.
std::vector<Result> front_of(std::vector<Result> results, double floor);

inline constexpr double kMinError = 1e-10;

}  // namespace ballpit
