// SPDX-License-Identifier: MIT
// Scenes whose outcome is known, by closed form or by exact motion, and how far each method's outcome is from it: the tasks of
// `work-precision`.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/experiments/contact_methods.h"

namespace ballpit {

/// One run of a method: how far off, and what it cost. A run that stops, or whose outcome is none, is off by infinity.
struct Trial {
  double off = 0;      ///< as a part of the true value; signed where it is a mean's
  double seconds = 0;  ///< of stepping, for a second simulated
};

struct Task {
  std::string name;    ///< the chart's file: "stack-10"
  std::string title;   ///< a sentence
  std::string error;   ///< what is off: "largest overlap / radius"
  std::string truth;   ///< what errors are against
  double coarsest;     ///< [s] dt0; steps are dt0·2^−k
  int quick_halvings;  ///< k of the finest step
  int full_halvings;
  bool is_mean;  ///< of many collisions: there is a statistical floor, and what the repeats are off has signs
  bool (*serves)(const ContactMethod&);
  std::function<Trial(const ContactMethod&, double dt, uint64_t seed, bool is_quick)> run;
};

/// All: contacts of few spheres, spheres at rest, gases.
const std::vector<Task>& tasks();

/// The mean error of restitution, |v'/v − e|, of head-on hits of springs that begin at different parts of a step, `steps` steps a
/// contact, against the closed form.
double restitution_error(const std::string& integrator, const std::string& precision, const std::string& law,
                         double restitution, double steps, int phases);

/// log2 of how much the error falls when steps are halved, between 40 and 160 steps a contact.
double order_of_restitution(const std::string& integrator, const std::string& law, double restitution);

}  // namespace ballpit
