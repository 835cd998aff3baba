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

#include <utility>

#include "bodies/bodies_view.h"
#include "core/span.h"

namespace ballpit {

/// Kernel: Σ += weight·k, then y ← start + reach·k, after the last stage start + Σ, where k is the derivative at y.
template <class Real>
struct RungeKuttaStage {
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
class RungeKutta4 {
  using Real = Scalar<V>;
  using Buffer = typename Exec::template Buffer<V>;

 public:
  /// Moves `state` by dt. forces.at(state, duration, counts, acceleration) evaluates them at its present positions.
  template <class State, class Forces>
  void step(State& state, Forces& forces, Real dt) {
    Exec& exec = state.exec();
    const int64_t n = state.count();
    for (Buffer* buffer : {&acceleration_, &start_position_, &start_velocity_, &moved_, &kicked_}) buffer->resize(n);
    exec.parallel_for("note start", n, CopyValues<V>{state.position.span(), start_position_.span()});
    exec.parallel_for("note start", n, CopyValues<V>{state.velocity.span(), start_velocity_.span()});
    constexpr Real kReach[] = {0.5, 0.5, 1, 0}, kWeight[] = {1, 2, 2, 1};
    for (int stage = 0; stage < 4; ++stage) {
      const Real weight = kWeight[stage] / 6 * dt;
      forces.at(state, weight, stage == 0, acceleration_.span());
      exec.parallel_for(
          "stage", n * kDimensions<V>,
          RungeKuttaStage<Real>{stage, kReach[stage] * dt, weight, of(start_position_), of(start_velocity_),
                                of(acceleration_), components(state.position.span()), components(state.velocity.span()),
                                components(moved_.span()), components(kicked_.span())});
      state.moved();
    }
  }

  int64_t bytes() const {
    return acceleration_.bytes() + start_position_.bytes() + start_velocity_.bytes() + moved_.bytes() + kicked_.bytes();
  }

 private:
  static Span<const Real> of(const Buffer& values) { return components(values.span()); }

  Buffer acceleration_, start_position_, start_velocity_, moved_, kicked_;
};

}  // namespace ballpit
