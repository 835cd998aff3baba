// SPDX-License-Identifier: MIT
// What both Euler methods share: one evaluation of the forces, then one kernel that moves each component of the bodies.
#pragma once

#include "core/math.h"
#include "core/span.h"

namespace ballpit {

/// An integrator with one kernel, `Step<Real>`, whose launch is named Step<Real>::kName.
template <class V, class Exec, template <class Real> class Step>
class OneStage {
 public:
  /// Moves `state` by dt. forces.at(state, duration, counts, acceleration) evaluates them at its present positions.
  template <class State, class Forces>
  void step(State& state, Forces& forces, Scalar<V> dt) {
    acceleration_.resize(state.count());
    forces.at(state, dt, true, acceleration_.span());
    state.exec().parallel_for(Step<Scalar<V>>::kName, state.count() * kDimensions<V>,
                              Step<Scalar<V>>{dt, components(Span<const V>(acceleration_.span())),
                                              components(state.position.span()), components(state.velocity.span())});
    state.moved();
  }

  int64_t bytes() const { return acceleration_.bytes(); }

 private:
  typename Exec::template Buffer<V> acceleration_;
};

}  // namespace ballpit
