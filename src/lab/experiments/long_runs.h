// SPDX-License-Identifier: MIT
// What long runs do to what should stay: energy and momentum.
#pragma once

#include <string>
#include <vector>

#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

/// Largest changes up to a time, each of the whole at the start.
struct LargestDrift {
  double energy = 0;    ///< |E − E₀|/E₀
  double momentum = 0;  ///< |P − P₀|/Σ m·|v|
};

/// Up to each of these times, ascending, looked at a few steps apart. Where a run stops, what follows is infinite.
std::vector<LargestDrift> drift_of(const Scene& scene, const Settings& settings, const std::vector<double>& times);

/// |E/E₀ − 1| at most, within 1, 2, 4, … 2^(count − 1) steps of a mass on a spring (a sphere that never leaves the floor) by the
/// penalty response; omega_dt = ω·dt. It is on the floor as long as its energy is below kOscillatorLeaves times that at the start.
inline constexpr double kOscillatorLeaves = 100;
std::vector<double> oscillator_drift(const std::string& integrator, double omega_dt, int count);

/// The same by theory, z = ω·dt: explicit Euler's (1 + z²)^n − 1, Runge–Kutta's 1 − (1 − z⁶/72 + z⁸/576)^n, and the bounds that the
/// others never cross, z²/4 of velocity Verlet and z/(2 − z) of symplectic Euler.
double oscillator_theory(const std::string& integrator, double omega_dt, double steps);

}  // namespace ballpit
