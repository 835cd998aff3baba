// SPDX-License-Identifier: MIT
// All that can be done about contacts, as cases to compare: every response with its integrators, solvers and precisions, from the
// table of methods.
#pragma once

#include <string>
#include <vector>

#include "lab/charts/chart.h"
#include "methods/settings.h"

namespace ballpit {

struct ContactMethod {
  std::string name;   ///< of its options: "penalty, rk4, float"
  std::string label;  ///< in charts, where its role tells the response: "penalty", and "+ rk4" of its others
  std::string role;   ///< the response's colour
  bool is_main;       ///< the response's own integrator and solver, in double precision
  Settings settings;  ///< one thread; its step is still to be set
};

const std::vector<ContactMethod>& contact_methods();

/// Whether it is a response's own integrator and solver in single precision.
bool is_float_of_main(const ContactMethod& method);

/// Its line in a chart: thin where it is not a main one; dashed and without a label, beside its double's, in single precision.
Series series_of(const ContactMethod& method);

/// Takes the label from thin lines that end within a tenth of where their response's main one does: they need none beside it.
void drop_equal_labels(std::vector<Series>& list);

/// Springs whose contacts last `steps` steps, as accuracy asks for at least 20: N/m for spheres of reduced mass mu [kg].
double stiffness_for(double dt, double steps, double mu, double restitution);

}  // namespace ballpit
