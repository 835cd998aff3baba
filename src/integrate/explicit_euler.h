// SPDX-License-Identifier: MIT
// Explicit Euler: positions and velocities both advance by their values before the step.
//
//     a ← forces(x, v) / m
//     x ← x + dt · v
//     v ← v + dt · a
//
// First order, and unstable for springs with any step: an oscillator's amplitude grows by √(1 + ω²dt²) in each. It is
// here to show how it fails. Cost: one evaluation of the forces. Source: Hairer, Lubich, Wanner, "Geometric Numerical
// Integration" (2006), section I.1. Its siblings: symplectic_euler.h, velocity_verlet.h, rk4.h.
#pragma once

#include "integrate/force_integrator.h"

namespace ballpit {

/// Kernel: moves one component of a body.
template <class Real>
struct ExplicitEulerStep {
  static constexpr bool kIsElementwise = true;
  static constexpr const char* kName = "drift and kick";
  Real dt;
  Span<const Real> acceleration;
  Span<Real> position, velocity;

  HOST_DEVICE void operator()(int k) const {
    position[k] = position[k] + velocity[k] * dt;
    velocity[k] += acceleration[k] * dt;
  }
};

template <class V, class Exec>
using ExplicitEuler = OnePass<V, Exec, ExplicitEulerStep>;

}  // namespace ballpit
