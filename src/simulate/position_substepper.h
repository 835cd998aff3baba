// SPDX-License-Identifier: MIT
// A substep of the position-based response:
//
//     kick ──▶ drift ──▶ contacts there, and near ones ──▶ respond
//
// Its siblings are velocity_substepper.h and force_substepper.h.
#pragma once

#include "simulate/integrate/symplectic_euler.h"
#include "simulate/substepper.h"
#include "simulate/response/position_based.h"

namespace ballpit {

/// Spheres that do not overlap where they are predicted may come to while others are moved: so
/// near ones are contacts, too.
template <class V, class Exec>
class PositionSubstepper final : public Substepper<V, Exec> {
  using Real = Scalar<V>;

 public:
  explicit PositionSubstepper(const PositionBasedParameters& parameters) : response_(parameters) {}

  void substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real h) override {
    Exec& exec = state.exec();
    const int64_t n = state.count();
    before_.resize(n);
    exec.parallel_for("note velocities", n, CopyValues<V>{state.velocity.span(), before_.span()});
    if (state.has_gravity()) {
      exec.parallel_for("kick", n, Kick<V>{before_.span(), state.gravity() * h, state.velocity.span()});
    }
    exec.parallel_for(
        "drift", n * kDimensions<V>,
        Drift<Real>{h, components(Span<const V>(state.velocity.span())), {}, components(state.position.span())});
    state.moved();
    const ContactsView<V> contacts = state.near_contacts();
    const ImpulseNotes<V> notes = tally.begin(exec, n, contacts.pairs.size());
    response_.respond(state, contacts, before_.span(), h, notes);
    tally.end(exec, state.bodies(), state.box(), contacts.pairs, contacts.geometry);
  }

  int64_t bytes() const override { return before_.bytes() + response_.bytes(); }

 private:
  PositionBasedResponse<V, Exec> response_;
  typename Exec::template Buffer<V> before_;
};

template <class V, class Exec>
std::unique_ptr<Substepper<V, Exec>> make_position_based_substepper(const Scene& scene, const Settings& settings) {
  const Physics& physics = scene.physics;
  return std::make_unique<PositionSubstepper<V, Exec>>(
      PositionBasedParameters{physics.restitution, physics.wall_restitution, settings.compliance,
                              length(physics.gravity), settings.iterations.value_or(1)});
}

}  // namespace ballpit
