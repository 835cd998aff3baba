// SPDX-License-Identifier: MIT
// Symplectic Euler: velocities first, then positions with the new velocities.
//
//     v ← v + dt · a         kick     (impulses: a = g, skipped in scenes without gravity)
//     v ← response(v)                 (impulses alone)
//     x ← x + dt · v         drift
//
// First order; the energy error stays bounded, for springs while ω·dt < 2. Cost: one evaluation of the forces. Source: Hairer,
// Lubich, Wanner, "Geometric Numerical Integration" (2006), section I.1. Its siblings: explicit_euler.h,
// velocity_verlet.h, rk4.h.
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

/// Kernel: position += dt · velocity + correction.
template <class V>
struct Drift {
  Scalar<V> dt;  ///< [s]
  Span<const V> velocity;
  Span<const V> correction;  ///< [m] empty where the response needs none
  Span<V> position;

  HOST_DEVICE void operator()(int i) const {
    V moved = position[i] + velocity[i] * dt;
    if (!correction.empty()) moved += correction[i];
    position[i] = moved;
  }
};

/// Kernel: kick and drift of body i by its own acceleration.
template <class V>
struct SymplecticEulerStep {
  Scalar<V> dt;
  Span<const V> acceleration;
  Span<V> position, velocity;

  HOST_DEVICE void operator()(int i) const {
    const V v = velocity[i] + acceleration[i] * dt;
    velocity[i] = v;
    position[i] = position[i] + v * dt;
  }
};

/// For responses that are forces.
template <class V, class Exec>
class SymplecticEuler {
 public:
  /// Moves `state` by dt. forces.at(state, duration, counts, acceleration) evaluates them at its present positions.
  template <class State, class Forces>
  void step(State& state, Forces& forces, Scalar<V> dt) {
    acceleration_.resize(state.count());
    forces.at(state, dt, true, acceleration_.span());
    state.exec().parallel_for(
        "kick and drift", state.count(),
        SymplecticEulerStep<V>{dt, acceleration_.span(), state.position.span(), state.velocity.span()});
    state.moved();
  }

  int64_t bytes() const { return acceleration_.bytes(); }

 private:
  typename Exec::template Buffer<V> acceleration_;
};

}  // namespace ballpit
