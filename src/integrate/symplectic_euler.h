// SPDX-License-Identifier: MIT
// Symplectic Euler: velocities first, then positions with the new velocities.
//
//     v ← v + dt · a         kick     (impulses: a = g, skipped in scenes without gravity)
//     v ← response(v)                 (only impulses)
//     x ← x + dt · v         drift
//
// First order; the energy error stays bounded, for springs if ω·dt < 2. Cost: one evaluation of the forces. Source:
// Hairer, Lubich, Wanner, "Geometric Numerical Integration" (2006), section I.1. Its siblings: explicit_euler.h,
// velocity_verlet.h, rk4.h.
#pragma once

#include "integrate/force_integrator.h"

namespace ballpit {

/// Kernel: out = velocity + dt · acceleration.
template <class V>
struct Kick {
  Span<const V> velocity;
  V change;  ///< dt · acceleration [m/s]
  Span<V> out;

  HOST_DEVICE void operator()(int i) const { out[i] = velocity[i] + change; }
};

/// Kernel: one component's position += dt · velocity + correction.
template <class Real>
struct Drift {
  static constexpr bool kIsElementwise = true;
  Real dt;  ///< [s]
  Span<const Real> velocity;
  Span<const Real> correction;  ///< [m] empty if the response needs none
  Span<Real> position;

  HOST_DEVICE void operator()(int k) const {
    Real moved = position[k] + velocity[k] * dt;
    if (!correction.empty()) moved += correction[k];
    position[k] = moved;
  }
};

/// Kernel: kick and drift of one component.
template <class Real>
struct SymplecticEulerStep {
  static constexpr bool kIsElementwise = true;
  static constexpr const char* kName = "kick and drift";
  Real dt;
  Span<const Real> acceleration;
  Span<Real> position, velocity;

  HOST_DEVICE void operator()(int k) const {
    const Real v = velocity[k] + acceleration[k] * dt;
    velocity[k] = v;
    position[k] = position[k] + v * dt;
  }
};

/// For responses that are forces.
template <class V, class Exec>
using SymplecticEuler = OnePass<V, Exec, SymplecticEulerStep>;

}  // namespace ballpit
