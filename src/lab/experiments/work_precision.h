// SPDX-License-Identifier: MIT
// The results of all methods for a task, with all their steps; and the Pareto front.
#pragma once

#include <cmath>

#include "lab/experiments/accuracy.h"
#include "measure/statistics.h"

namespace ballpit {

/// A method at one step.
struct Result {
  const ContactMethod* method;
  double dt;                  ///< [s]
  double error = 0;           ///< infinite if it failed
  double standard_error = 0;  ///< of the repeats
  Spread seconds = {};        ///< of computation for a simulated second
  bool has_failed() const { return !std::isfinite(error); }
};

/// The methods for a task. In single precision, quick runs use main methods only.
std::vector<const ContactMethod*> methods_of(const Task& task, bool is_quick);

/// The Pareto front: results that no other beats in both error and time, fastest first. Errors below `floor` and
/// kMinError count as these.
std::vector<Result> front_of(std::vector<Result> results, double floor);

inline constexpr double kMinError = 1e-10;

}  // namespace ballpit
