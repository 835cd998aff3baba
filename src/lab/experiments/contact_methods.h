// SPDX-License-Identifier: MIT
// All methods that resolve contacts, to be compared: every response with its integrators, solvers and precisions, from
// the table of methods.
#pragma once

#include "lab/charts/chart.h"
#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

struct ContactMethod {
  std::string name;   ///< its options: "penalty, rk4, float"
  std::string label;  ///< in charts, where the colour shows the response: "penalty", or "+ rk4" for its variants
  std::string role;   ///< the colour of the response
  bool is_main;       ///< with the default integrator and solver of the response, in double precision
  Settings settings;  ///< one thread; dt is not set
};

const std::vector<ContactMethod>& contact_methods();

inline Settings with_step(const ContactMethod& method, double dt) {
  Settings settings = method.settings;
  settings.dt = dt;
  return settings;
}

/// Whether this is the main method of a response, but in single precision.
bool is_float_of_main(const ContactMethod& method);

/// Whether its error depends on the step: not that of exact motion.
bool has_steps(const ContactMethod& method);

/// Its line in a chart: thin unless it is a main method; dashed and without a label in single precision.
Series series_of(const ContactMethod& method);

/// Clears the labels of thin lines that end within a tenth of the main line of their response.
void drop_equal_labels(std::vector<Series>& list);

/// The stiffness [N/m] with which contacts of reduced mass mu [kg] last `steps` steps. Accuracy needs at least 20.
double stiffness_for(double dt, double steps, double mu, double restitution);

inline constexpr double kStepsOfContact = 20;  ///< of springs whose stiffness follows from the step

/// A gas of spheres of mass 1 with such springs, which only the penalty response uses.
Scene with_springs(Scene gas, double dt);

}  // namespace ballpit
