// SPDX-License-Identifier: MIT
// The classical Runge–Kutta method evaluates the forces four times: at the start, twice in the middle and at the end of
// a step.
//
//     k₁ = f(y)   k₂ = f(y + dt/2·k₁)   k₃ = f(y + dt/2·k₂)   k₄ = f(y + dt·k₃)       y = (x, v), f = (v, a)
//     y ← y + dt/6 · (k₁ + 2k₂ + 2k₃ + k₄)
//
// Fourth order for smooth forces; those of contacts are not smooth, so it gains little (docs/responses.md). Stable for
// springs if ω·dt < 2.83; loses energy slowly. Cost: four searches for contacts and evaluations of the forces a step.
// Source: Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I" (1993), section II.1. Its siblings:
// explicit_euler.h, symplectic_euler.h, velocity_verlet.h.
#pragma once

#include "bodies/bodies_view.h"
#include "integrate/force_integrator.h"

namespace ballpit {

/// Kernel: Σ += weight·k, then y ← start + reach·k, after the last stage start + Σ, where k is the derivative at y.
template <class Real>
struct RungeKuttaStage {
  static constexpr bool kIsElementwise = true;
  int stage;
  Real reach, weight;  ///< [s]
  Span<const Real> start_position, start_velocity, acceleration;
  Span<Real> position, velocity, moved, kicked;

  HOST_DEVICE void operator()(int k) const {
    const Real v = velocity[k], a = acceleration[k];
    const Real sum = stage == 0 ? v * weight : moved[k] + v * weight;
    const Real change = stage == 0 ? a * weight : kicked[k] + a * weight;
    moved[k] = sum;
    kicked[k] = change;
    position[k] = start_position[k] + (stage < 3 ? v * reach : sum);
    velocity[k] = start_velocity[k] + (stage < 3 ? a * reach : change);
  }
};

template <class V, class Exec>
class RungeKutta4 : public ForceIntegrator<V, Exec> {
  using Real = Scalar<V>;
  using Base = ForceIntegrator<V, Exec>;
  using Buffer = typename Exec::template Buffer<V>;

 public:
  using Base::Base;

  static constexpr int kPasses = 4;

  Real duration(Real dt, int pass) const {
    constexpr Real kWeight[] = {1, 2, 2, 1};
    return kWeight[pass] / 6 * dt;
  }

  template <class Bodies>
  bool before_forces(Bodies& bodies, Real, int pass) {
    if (pass > 0) return false;
    const int64_t n = bodies.count();
    for (Buffer* buffer : {&start_position_, &start_velocity_, &moved_, &kicked_}) buffer->resize(n);
    Exec& exec = bodies.exec();
    exec.parallel_for("note start", n, CopyValues<V>{bodies.position.span(), start_position_.span()});
    exec.parallel_for("note start", n, CopyValues<V>{bodies.velocity.span(), start_velocity_.span()});
    return false;
  }

  template <class Bodies>
  bool after_forces(Bodies& bodies, Real dt, int pass) {
    constexpr Real kReach[] = {0.5, 0.5, 1, 0};
    bodies.exec().parallel_for(
        "stage", bodies.count() * kDimensions<V>,
        RungeKuttaStage<Real>{pass, kReach[pass] * dt, duration(dt, pass), of(start_position_), of(start_velocity_),
                              this->accelerations(), components(bodies.position.span()),
                              components(bodies.velocity.span()), components(moved_.span()),
                              components(kicked_.span())});
    return true;
  }

  int64_t bytes() const {
    return Base::bytes() + start_position_.bytes() + start_velocity_.bytes() + moved_.bytes() + kicked_.bytes();
  }

 private:
  static Span<const Real> of(const Buffer& values) { return components(Span<const V>(values.span())); }

  Buffer start_position_, start_velocity_, moved_, kicked_;
};

}  // namespace ballpit
