// SPDX-License-Identifier: MIT
// What the methods make of a task: all at all their steps, repeated in turns, and who is beaten by nobody.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "lab/experiments/accuracy.h"
#include "lab/measure/lab.h"
#include "measure/spread.h"

namespace ballpit {

/// A method at one step.
struct Result {
  const ContactMethod* method;
  double dt;              ///< [s]
  double error;           ///< infinite where it failed
  double standard_error;  ///< where errors are of random runs
  Spread seconds;         ///< for a second simulated
  bool has_failed() const { return !std::isfinite(error); }
};

bool has_steps(const ContactMethod& method);

/// Those that serve a task. Quick runs leave out other than main ones in single precision.
std::vector<const ContactMethod*> methods_of(const Task& task, bool is_quick);

/// Of each method at all its steps, in the order of methods_of() and from the coarsest step on. Each repeat is one of all
/// methods at all steps, so that what else the machine does falls on all alike.
std::vector<Result> results_of(Lab& lab, const Task& task);

/// How many measurements that takes.
int64_t trial_count(const Task& task, bool is_quick);

/// The typical standard error of those that did not fail: what is below it is chance. 0 where nothing is random.
double floor_of(const Task& task, const std::vector<Result>& results);

/// Those that nobody beats in both error and time, fastest first: the Pareto front. Errors below `floor` are as good as it, and
/// those below kLeastError as good as that.
std::vector<Result> front_of(std::vector<Result> results, double floor);

inline constexpr double kLeastError = 1e-10;

}  // namespace ballpit
