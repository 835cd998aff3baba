// SPDX-License-Identifier: MIT
// The responses that `crossover` compares, and the largest step with which each keeps the error in the pressure of a
// dense gas within the same tolerance; diameter, mass and kT are 1.
#pragma once

#include <string>
#include <vector>

#include "lab/measure/lab.h"
#include "measure/statistics.h"
#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

inline constexpr double kSameErrorDensity = 0.5;    ///< N·D³/V
inline constexpr double kPressureTolerance = 0.02;  ///< of Z
inline constexpr double kCoarsestStep = 0.256;      ///< dt₀; steps are dt₀·2^−k
inline constexpr int kStepsTried = 12;              ///< at most, for each response

/// A response with its settings, on one thread in double precision.
struct Contender {
  std::string label, role;
  bool is_dashed;
  Settings (*settings)(double dt);
};

const std::vector<Contender>& contenders();  ///< exact motion first

bool is_exact(const Contender& who);

/// The gas with springs whose contacts last twenty steps. Only the penalty response uses them.
Scene with_springs(Scene gas, double dt);

struct PressureError {
  double dt;
  Mean off;  ///< Z/Z_N − 1; NaN if the run stopped
};

/// The error at each step, coarsest first, until two in a row are within the tolerance.
std::vector<PressureError> pressure_errors(Lab& lab, const Contender& who);

/// The coarser of the two steps in a row that are within the tolerance; 0 if there are none.
double largest_step(const std::vector<PressureError>& errors);

}  // namespace ballpit
