// SPDX-License-Identifier: MIT
// The tasks of `work-precision`: scenes whose outcome is known from a closed form or from exact motion, and the error
// of each method in them.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "lab/experiments/contact_methods.h"

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

inline Settings with_step(const ContactMethod& method, double dt) {
  Settings settings = method.settings;
  settings.dt = dt;
  return settings;
}

/// The order with which the error of the penalty response's restitution falls with the step, between 40 and 160 steps
/// per contact: that of the mean |v'/v − e| over hits that start at different moments of a step.
double order_of_restitution(const std::string& integrator, const std::string& law, double restitution);

}  // namespace ballpit
