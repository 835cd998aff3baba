// SPDX-License-Identifier: MIT
// The classical Runge–Kutta method: four evaluations of the forces, at the begin, twice in the middle and at the end of the step.
//
//     k₁ = f(y)   k₂ = f(y + dt/2·k₁)   k₃ = f(y + dt/2·k₂)   k₄ = f(y + dt·k₃)       y = (x, v), f = (v, a)
//     y ← y + dt/6 · (k₁ + 2k₂ + 2k₃ + k₄)
//
// Fourth order where forces are smooth; contacts are not, so it earns little (docs/responses.md). Stable for springs while ω·dt < 2.83; loses
// energy slowly. Contacts are found four times a step. Source: Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations
// I" (1993), section II.1. Its siblings: explicit_euler.h, symplectic_euler.h, velocity_verlet.h.
#pragma once

#include <utility>

#include "simulate/state.h"

namespace ballpit {

/// Kernel: y ← start + reach·k, and Σ += weight·k. k is the rate at the present y.
template <class V>
struct RungeKuttaStage {
  Box<V> box;
  Scalar<V> reach, weight;  ///< [s]
  Span<const V> start_position, start_velocity, acceleration;
  Span<V> position, velocity, moved, kicked;
  bool is_first;

  HOST_DEVICE void operator()(int i) const {
    const V v = velocity[i], a = acceleration[i];
    moved[i] = is_first ? v * weight : moved[i] + v * weight;
    kicked[i] = is_first ? a * weight : kicked[i] + a * weight;
    position[i] = box.wrap(start_position[i] + v * reach);
    velocity[i] = start_velocity[i] + a * reach;
  }
};

/// Kernel: y ← start + Σ.
template <class V>
struct RungeKuttaEnd {
  Box<V> box;
  Span<const V> start_position, start_velocity, moved, kicked;
  Span<V> position, velocity;

  HOST_DEVICE void operator()(int i) const {
    position[i] = box.wrap(start_position[i] + moved[i]);
    velocity[i] = start_velocity[i] + kicked[i];
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
      exec.parallel_for("stage", n,
                        RungeKuttaStage<V>{state.box(), kReach[stage] * dt, weight, start_position_.span(),
                                           start_velocity_.span(), acceleration_.span(), state.position.span(),
                                           state.velocity.span(), moved_.span(), kicked_.span(), stage == 0});
      state.moved();
    }
    exec.parallel_for("end of stages", n,
                      RungeKuttaEnd<V>{state.box(), start_position_.span(), start_velocity_.span(), moved_.span(),
                                       kicked_.span(), state.position.span(), state.velocity.span()});
  }

  int64_t bytes() const {
    return acceleration_.bytes() + start_position_.bytes() + start_velocity_.bytes() + moved_.bytes() + kicked_.bytes();
  }

 private:
  Buffer acceleration_, start_position_, start_velocity_, moved_, kicked_;
};

}  // namespace ballpit
