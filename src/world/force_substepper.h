// SPDX-License-Identifier: MIT
// A substep of the penalty response, by any integrator, which asks for forces once or more:
//
//     integrator { candidates ──▶ forces }
//
// Its siblings are velocity_substepper.h and position_substepper.h.
#pragma once

#include <string>

#include "bodies/pair.h"
#include "core/span.h"
#include "integrate/explicit_euler.h"
#include "integrate/rk4.h"
#include "integrate/symplectic_euler.h"
#include "integrate/velocity_verlet.h"
#include "methods/methods.h"
#include "response/impulse_notes.h"
#include "response/penalty.h"
#include "world/substepper.h"

namespace ballpit {

template <class V, class Exec, class Integrator>
class ForceSubstepper final : public Substepper<V, Exec> {
  using Real = Scalar<V>;

 public:
  explicit ForceSubstepper(const PenaltyLaw<Real>& law) : response_(law) {}

  void substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real dt) override {
    Forces forces{response_, tally};
    integrator_.step(state, forces, dt);
  }

  double elastic_energy(StepState<V, Exec>& state) const override {
    return response_.elastic_energy(state.exec(), state.bodies(), state.box(), state.pairs());
  }

  std::vector<typename Exec::template Buffer<V>*> kept() override {
    if constexpr (requires { integrator_.kept(); }) return {integrator_.kept()};
    return {};
  }

  int64_t bytes() const override { return response_.bytes() + integrator_.bytes(); }

 private:
  /// What integrators evaluate.
  struct Forces {
    PenaltyResponse<V, Exec>& response;
    TallyKeeper<V, Exec>& tally;

    bool depend_on_velocity() const { return response.depends_on_velocity(); }

    /// The accelerations at the present positions, which act for `duration`; `counts`: new contacts are collisions.
    void at(StepState<V, Exec>& state, Real duration, bool counts, Span<V> acceleration) {
      const Span<const Pair> pairs = state.near_pairs().pairs;
      const ImpulseNotes<V> notes = tally.begin(state.exec(), state.count(), pairs.size());
      response.accelerate(state, duration, notes, acceleration);
      tally.end(state.exec(), state.bodies(), state.box(), pairs, {}, counts);
    }
  };

  PenaltyResponse<V, Exec> response_;
  Integrator integrator_;
};

template <class Real>
PenaltyLaw<Real> penalty_law(const Scene& scene, const Settings& settings) {
  const Physics& physics = scene.physics;
  const bool ends_with_force = settings.contact_end == ContactEnd::force,
             has_walls = scene.domain.boundary != Boundary::periodic;
  return {static_cast<Real>(physics.stiffness),
          static_cast<Real>(damping_of(physics.restitution, ends_with_force)),
          has_walls ? static_cast<Real>(damping_of(physics.wall_restitution, ends_with_force)) : Real(0),
          static_cast<Real>(physics.shear),
          physics.law == "hertz",
          ends_with_force};
}

template <class V, class Exec>
std::unique_ptr<Substepper<V, Exec>> make_penalty_substepper(const Scene& scene, const Settings& settings) {
  const PenaltyLaw<Scalar<V>> law = penalty_law<Scalar<V>>(scene, settings);
  const Integrator integrator = integrator_of(settings);
  if (integrator == Integrator::explicit_euler)
    return std::make_unique<ForceSubstepper<V, Exec, ExplicitEuler<V, Exec>>>(law);
  if (integrator == Integrator::symplectic_euler)
    return std::make_unique<ForceSubstepper<V, Exec, SymplecticEuler<V, Exec>>>(law);
  if (integrator == Integrator::rk4) return std::make_unique<ForceSubstepper<V, Exec, RungeKutta4<V, Exec>>>(law);
  return std::make_unique<ForceSubstepper<V, Exec, VelocityVerlet<V, Exec>>>(law);
}

}  // namespace ballpit
