// SPDX-License-Identifier: MIT
// Explicit Euler: positions and velocities both move by what was before the step.
//
//     a ← forces(x, v) / m
//     x ← x + dt · v
//     v ← v + dt · a
//
// First order, and unstable for springs at any step: an oscillator's amplitude grows by √(1 + ω²dt²) in each. Here to be seen
// failing. Cost: one evaluation of the forces. Source: Hairer, Lubich, Wanner, "Geometric Numerical Integration" (2006),
// section I.1. Its siblings: symplectic_euler.h, velocity_verlet.h, rk4.h.
#pragma once

#include "core/host_device.h"
#include "core/span.h"
#include "integrate/force_integrator.h"

namespace ballpit {

/// Kernel: moves one component of a body.
template <class Real>
struct ExplicitEulerStep {
  Real dt;
  Span<const Real> acceleration;
  Span<Real> position, velocity;

  HOST_DEVICE void operator()(int k) const {
    position[k] = position[k] + velocity[k] * dt;
    velocity[k] += acceleration[k] * dt;
  }
};

template <class V, class Exec>
class ExplicitEuler : public ForceIntegrator<V, Exec> {
 public:
  using ForceIntegrator<V, Exec>::ForceIntegrator;

  template <class Bodies>
  bool after_forces(Bodies& bodies, Scalar<V> dt, int) {
    bodies.exec().parallel_for(
        "drift and kick", bodies.count() * kDimensions<V>,
        ExplicitEulerStep<Scalar<V>>{dt, this->accelerations(), components(bodies.position.span()),
                                     components(bodies.velocity.span())});
    return true;
  }
};

}  // namespace ballpit
