// SPDX-License-Identifier: MIT
// The contenders of `crossover`, and the largest step at which each holds the same error in the pressure of a dense gas; diameter,
// mass and kT are 1.
#pragma once

#include <string>
#include <vector>

#include "lab/measure/lab.h"
#include "lab/measure/mean.h"
#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

inline constexpr double kSameErrorDensity = 0.5;    ///< N·D³/V
inline constexpr double kPressureTolerance = 0.02;  ///< of Z
inline constexpr double kCoarsestStep = 0.256;      ///< dt₀; steps are dt₀·2^−k
inline constexpr int kStepsTried = 12;              ///< of each contender, at most

/// A response with its options, on one thread in double precision.
struct Contender {
  std::string label, role;
  bool is_dashed;
  Settings (*settings)(double dt);
};

const std::vector<Contender>& contenders();  ///< exact motion first

bool is_exact(const Contender& who);

/// The gas with springs whose contacts last twenty steps; nobody but penalty looks at them.
Scene with_springs(Scene gas, double dt);

struct PressureError {
  double dt;
  Mean off;  ///< Z/Z_N − 1; not a number where the run stopped
};

/// The error at each step, coarsest first, until two in a row hold the tolerance.
std::vector<PressureError> pressure_errors(Lab& lab, const Contender& who);

/// The coarser of the two steps in a row that hold the tolerance; 0 where there are none.
double largest_step(const std::vector<PressureError>& errors);

}  // namespace ballpit
