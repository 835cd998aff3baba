// SPDX-License-Identifier: MIT
// Symplectic Euler: velocities first, then positions with the new velocities.
//
//     v ← v + dt · g         kick     (skipped in scenes without gravity)
//     v ← response(v)
//     x ← x + dt · v         drift
//
// Cost: two passes. First order; the energy error stays bounded. Source: Hairer, Lubich, Wanner, "Geometric Numerical
// Integration" (2006), section I.1.
#pragma once

#include "simulate/state.h"

namespace ballpit {

/// Kernel: out = velocity + dt · acceleration.
template <class V>
struct Kick {
  Span<const V> velocity;
  V change;  ///< dt · acceleration [m/s]
  Span<V> out;

  HOST_DEVICE void operator()(int i) const { out[i] = velocity[i] + change; }
};

/// Kernel: position += dt · velocity + correction, wrapped into a periodic domain.
template <class V>
struct Drift {
  Box<V> box;
  Scalar<V> dt;  ///< [s]
  Span<const V> velocity;
  Span<const V> correction;  ///< [m] empty where the response needs none
  Span<V> position;

  HOST_DEVICE void operator()(int i) const {
    V moved = position[i] + velocity[i] * dt;
    if (!correction.empty()) moved += correction[i];
    position[i] = box.wrap(moved);
  }
};

}  // namespace ballpit
