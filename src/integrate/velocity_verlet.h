// SPDX-License-Identifier: MIT
// Velocity Verlet: half a kick, a drift, and half a kick by the forces at the new positions.
//
//     v½ ← v + dt/2 · forces(x, v) / m
//     x  ← x + dt · v½
//     v  ← v½ + dt/2 · forces(x, v½) / m
//
// Second order, symplectic, stable for springs if ω·dt < 2; only first order if a dashpot makes the force jump at the
// start of a contact. The first forces are evaluated with the present velocities instead of reusing those of the
// previous step. So a state consists of positions and velocities only, and a saved state continues bit-identically
// (docs/model.md: where bodies are sorted). If forces do not depend on velocities, both evaluations are equal, and one
// suffices. Cost: one search for contacts; one evaluation of the forces, or two. Source: Swope, Andersen, Berens,
// Wilson (1982), doi 10.1063/1.442716. Its siblings: explicit_euler.h, symplectic_euler.h, rk4.h.
#pragma once

#include "core/host_device.h"
#include "core/math.h"
#include "core/span.h"

namespace ballpit {

/// Kernel: the first half kick and the drift of one component.
template <class Real>
struct HalfKickAndDrift {
  Real dt;
  Span<const Real> acceleration;
  Span<Real> position, velocity;

  HOST_DEVICE void operator()(int k) const {
    const Real v = velocity[k] + acceleration[k] * (dt / 2);
    velocity[k] = v;
    position[k] = position[k] + v * dt;
  }
};

/// Kernel: the second half kick.
template <class Real>
struct HalfKick {
  Real dt;
  Span<const Real> acceleration;
  Span<Real> velocity;

  HOST_DEVICE void operator()(int k) const { velocity[k] += acceleration[k] * (dt / 2); }
};

template <class V, class Exec>
class VelocityVerlet {
  using Buffer = typename Exec::template Buffer<V>;

 public:
  /// Moves `state` by dt. forces.at(state, duration, counts, acceleration) evaluates them at its present positions.
  template <class State, class Forces>
  void step(State& state, Forces& forces, Scalar<V> dt) {
    Exec& exec = state.exec();
    const int64_t n = state.count();
    const Scalar<V> half = dt / 2;
    if (forces.depend_on_velocity() || acceleration_.size() != n) {
      acceleration_.resize(n);
      forces.at(state, half, false, acceleration_.span());
    }
    const Span<const V> acceleration = acceleration_.span();
    exec.parallel_for("half kick and drift", n * kDimensions<V>,
                      HalfKickAndDrift<Scalar<V>>{dt, components(acceleration), components(state.position.span()),
                                                  components(state.velocity.span())});
    state.moved();
    forces.at(state, forces.depend_on_velocity() ? half : dt, true, acceleration_.span());
    exec.parallel_for("half kick", n * kDimensions<V>,
                      HalfKick<Scalar<V>>{dt, components(acceleration), components(state.velocity.span())});
  }

  /// The array of one value per body that lasts from step to step.
  Buffer* kept() { return &acceleration_; }

  int64_t bytes() const { return acceleration_.bytes(); }

 private:
  Buffer acceleration_;
};

}  // namespace ballpit
