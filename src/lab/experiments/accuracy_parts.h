// SPDX-License-Identifier: MIT
// The parts of the table of tasks, a file each, and what they share.
#pragma once

#include <limits>
#include <vector>

#include "lab/experiments/accuracy.h"

namespace ballpit {

std::vector<Task> contact_tasks();  ///< few spheres that hit each other, or a floor
std::vector<Task> rest_tasks();     ///< spheres that carry spheres
std::vector<Task> gas_tasks();      ///< many collisions

inline constexpr double kStepsOfContact = 20;  ///< of springs, where their stiffness follows from the step

inline Settings with_step(const ContactMethod& method, double dt) {
  Settings settings = method.settings;
  settings.dt = dt;
  return settings;
}

inline constexpr double kFailed = std::numeric_limits<double>::infinity();  ///< what a run that stops is off by

inline bool is_any(const ContactMethod&) { return true; }

}  // namespace ballpit
