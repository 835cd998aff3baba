// SPDX-License-Identifier: MIT
// The tasks of `work-precision`: scenes whose outcome is known from a closed form or from exact motion, and the error
// of each method in them; the results of all methods, and their Pareto front.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "lab/experiments/contact_methods.h"
#include "measure/statistics.h"

namespace ballpit {

/// One run of a method.
struct Trial {
  double off = 0;  ///< error relative to the true value, with a sign for tasks of means; kFailed for a run that stops
  double seconds = 0;  ///< computation time of steps per simulated second
};

inline constexpr double kFailed = std::numeric_limits<double>::infinity();

struct Task {
  std::string name;                   ///< of the chart's file: "stack-10"
  std::string title;                  ///< a sentence
  std::string error;                  ///< the quantity: "largest overlap / radius"
  std::string truth;                  ///< its true value
  double coarsest;                    ///< [s] dt0; steps are dt0·2^−k
  int quick_halvings, full_halvings;  ///< k of the finest step
  std::function<Trial(const Settings&, uint64_t seed, bool is_quick)> run;  ///< with a method's settings and a step
  bool is_mean = false;  ///< over many collisions, so that small errors are chance
  bool (*serves)(const ContactMethod&) = [](const ContactMethod&) { return true; };
};

const std::vector<Task>& tasks();

std::vector<Task> gas_tasks();  ///< those of many collisions

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

/// The order with which the error of the penalty response's restitution falls with the step, between 40 and 160 steps
/// per contact: that of the mean |v'/v − e| over hits that start at different moments of a step.
double order_of_restitution(const std::string& integrator, const std::string& law, double restitution);

}  // namespace ballpit
