// SPDX-License-Identifier: MIT
// The form of all integrators of forces. A step consists of passes; each evaluates the forces once:
//
//     before_forces() ──▶ contacts ──▶ forces at the present positions, into acceleration() ──▶ after_forces()
//
// Here are the defaults: one pass, and nothing before the forces. Derived classes hide what differs.
#pragma once

#include "core/math.h"
#include "core/span.h"

namespace ballpit {

template <class V, class Exec>
class ForceIntegrator {
  using Real = Scalar<V>;

 public:
  explicit ForceIntegrator(bool forces_depend_on_velocity) : forces_depend_on_velocity_(forces_depend_on_velocity) {}

  static constexpr int kPasses = 1;
  static constexpr int kCollisionPass = 0;  ///< contacts that are new in this pass count as collisions

  int first_pass(int64_t /*bodies*/) const { return 0; }
  Real duration(Real dt, int /*pass*/) const { return dt; }  ///< [s] that the forces of a pass act

  /// [m/s²] of each body.
  Span<V> acceleration(int64_t bodies) {
    acceleration_.resize(bodies);
    return acceleration_.span();
  }

  /// Returns whether it has changed positions, as after_forces() does, which each integrator has of its own. dt [s].
  template <class Bodies>
  bool before_forces(Bodies&, Real /*dt*/, int /*pass*/) {
    return false;
  }

  /// What is kept for each body from step to step, or null.
  typename Exec::template Buffer<V>* kept() { return nullptr; }

  int64_t bytes() const { return acceleration_.bytes(); }

 protected:
  Span<const Real> accelerations() const { return components(Span<const V>(acceleration_.span())); }

  bool forces_depend_on_velocity_;
  typename Exec::template Buffer<V> acceleration_;
};

/// An integrator of one pass and one kernel, `Step<Real>`, whose launch is named Step<Real>::kName.
template <class V, class Exec, template <class Real> class Step>
class OnePass : public ForceIntegrator<V, Exec> {
 public:
  using ForceIntegrator<V, Exec>::ForceIntegrator;

  template <class Bodies>
  bool after_forces(Bodies& bodies, Scalar<V> dt, int) {
    bodies.exec().parallel_for(Step<Scalar<V>>::kName, bodies.count() * kDimensions<V>,
                               Step<Scalar<V>>{dt, this->accelerations(), components(bodies.position.span()),
                                               components(bodies.velocity.span())});
    return true;
  }
};

}  // namespace ballpit
