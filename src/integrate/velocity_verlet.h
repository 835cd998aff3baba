// SPDX-License-Identifier: MIT
// Velocity Verlet: half a kick, a drift, and half a kick by the forces at the new positions.
//
//     v½ ← v + dt/2 · forces(x, v) / m
//     x  ← x + dt · v½
//     v  ← v½ + dt/2 · forces(x, v½) / m
//
// Second order, symplectic, stable for springs if ω·dt < 2; only first order if a dashpot makes the force jump at the
// start of a contact. The first forces are evaluated with the present velocities, so a state consists of positions and
// velocities only (docs/responses.md). If forces do not depend on velocities, both evaluations are equal, and one
// suffices. Cost: one search for contacts; one evaluation of the forces, or two. Source: Swope, Andersen, Berens,
// Wilson (1982), doi 10.1063/1.442716. Its siblings: explicit_euler.h, symplectic_euler.h, rk4.h.
#pragma once

#include "integrate/force_integrator.h"

namespace ballpit {

/// Kernel: the first half kick and the drift of one component.
template <class Real>
struct HalfKickAndDrift {
  static constexpr bool kIsElementwise = true;
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
  static constexpr bool kIsElementwise = true;
  Real dt;
  Span<const Real> acceleration;
  Span<Real> velocity;

  HOST_DEVICE void operator()(int k) const { velocity[k] += acceleration[k] * (dt / 2); }
};

/// Pass 0 evaluates the forces at the start, where those of the step before do not serve; pass 1 moves the bodies, and
/// evaluates the forces at the end.
template <class V, class Exec>
class VelocityVerlet : public ForceIntegrator<V, Exec> {
  using Real = Scalar<V>;

 public:
  using ForceIntegrator<V, Exec>::ForceIntegrator;

  static constexpr int kPasses = 2;
  static constexpr int kCollisionPass = 1;

  int first_pass(int64_t bodies) const {
    return this->forces_depend_on_velocity_ || this->acceleration_.size() != bodies ? 0 : 1;
  }
  Real duration(Real dt, int pass) const { return pass == 0 || this->forces_depend_on_velocity_ ? dt / 2 : dt; }

  template <class Bodies>
  bool before_forces(Bodies& bodies, Real dt, int pass) {
    if (pass == 0) return false;
    bodies.exec().parallel_for("half kick and drift", bodies.count() * kDimensions<V>,
                               HalfKickAndDrift<Real>{dt, this->accelerations(), components(bodies.position.span()),
                                                      components(bodies.velocity.span())});
    return true;
  }

  template <class Bodies>
  bool after_forces(Bodies& bodies, Real dt, int pass) {
    if (pass == 0) return false;
    bodies.exec().parallel_for("half kick", bodies.count() * kDimensions<V>,
                               HalfKick<Real>{dt, this->accelerations(), components(bodies.velocity.span())});
    return false;
  }

  auto* kept() { return &this->acceleration_; }
};

}  // namespace ballpit
