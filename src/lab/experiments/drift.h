// SPDX-License-Identifier: MIT
// The change of energy and momentum, which should stay constant, in long runs.
#pragma once

#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

/// Largest changes up to a time, relative to the start.
struct LargestDrift {
  double energy = 0;    ///< |E − E₀|/E₀
  double momentum = 0;  ///< |P − P₀|/Σ m·|v|
};

/// Up to each of these ascending times, checked every few steps. Infinite from the time at which a run stops.
std::vector<LargestDrift> drift_of(const Scene& scene, const Settings& settings, const std::vector<double>& times);

/// The largest |E/E₀ − 1| within 1, 2, 4, … 2^(count − 1) steps of a mass on a spring, which is a sphere on the floor
/// with the penalty response; omega_dt = ω·dt.
std::vector<double> oscillator_drift(const std::string& integrator, double omega_dt, int count);

/// The same by theory, z = ω·dt: (1 + z²)^n − 1 for explicit Euler, 1 − (1 − z⁶/72 + z⁸/576)^n for Runge–Kutta, and the
/// bounds z²/4 for velocity Verlet and z/(2 − z) for symplectic Euler.
double oscillator_theory(const std::string& integrator, double omega_dt, double steps);

/// The sphere leaves the floor when its energy exceeds this multiple of its energy at the start.
inline constexpr double kOscillatorLeaves = 100;

}  // namespace ballpit
