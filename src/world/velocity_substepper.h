// SPDX-License-Identifier: MIT
// A substep of the responses that change velocities, kinematic and impulse:
//
//     contacts ──▶ kick ──▶ respond ──▶ drift
//     kick ──▶ contacts on the way ──▶ respond ──▶ drift        where contacts are swept: swept.h
//
// Its siblings are force_substepper.h and position_substepper.h.
#pragma once

#include <utility>

#include "bodies/bodies_view.h"
#include "bodies/contacts.h"
#include "core/span.h"
#include "integrate/symplectic_euler.h"
#include "response/impulse_notes.h"
#include "response/walls_view.h"
#include "world/substepper.h"
#include "world/swept.h"

namespace ballpit {

template <class V, class Exec, class Response>
class VelocitySubstepper final : public Substepper<V, Exec> {
  using Real = Scalar<V>;
  using Buffer = typename Exec::template Buffer<V>;

 public:
  /// `wall_restitution` is needed where contacts are swept.
  VelocitySubstepper(Response response, bool is_swept, double wall_restitution)
      : response_(std::move(response)), is_swept_(is_swept), wall_restitution_(static_cast<Real>(wall_restitution)) {}

  void substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real dt) override {
    after_.resize(state.count());
    is_swept_ ? swept_substep(state, tally, dt) : plain_substep(state, tally, dt);
    state.moved();
  }

  int64_t bytes() const override {
    return after_.bytes() + end_.bytes() + flown_.bytes() + response_.bytes() + swept_.bytes();
  }

 private:
  void plain_substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real dt) {
    Exec& exec = state.exec();
    const int64_t n = state.count();
    const BodiesView<V> bodies = state.bodies();
    Span<const V> kicked = bodies.velocity;
    if (state.has_gravity()) {
      exec.parallel_for("kick", n, Kick<V>{bodies.velocity, state.gravity() * dt, after_.span()});
      kicked = after_.span();
    }
    const ContactsView<V> contacts = state.contacts();
    const ImpulseNotes<V> notes = tally.begin(exec, n, contacts.pairs.size());
    response_.respond(exec, bodies, {state.box(), {}}, contacts, dt, kicked, after_, notes);
    tally.end(exec, bodies, state.box(), contacts.pairs, contacts.geometry);
    std::swap(state.velocity, after_);
    exec.parallel_for("drift", n * kDimensions<V>,
                      Drift<Real>{dt, components(Span<const V>(state.velocity.span())),
                                  components(response_.correction()), components(state.position.span())});
  }

  void swept_substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real dt) {
    Exec& exec = state.exec();
    const int64_t n = state.count();
    const BodiesView<V> bodies = state.bodies();
    const ContactsView<V> contacts = swept_.find(state, dt);
    const Sweep<V> sweep = swept_.sweep();
    const ImpulseNotes<V> notes = tally.begin(exec, n, contacts.pairs.size());
    const Span<const V> kicked = swept_.kicked(state);
    response_.respond(exec, swept_.bodies(state), {state.box(), sweep}, contacts, dt, kicked, after_, notes);
    end_.resize(n);
    flown_.resize(n);
    exec.parallel_for("swept drift", n,
                      SweptDrift<V>{bodies, state.box(), contacts, sweep, after_.span(), response_.correction(), kicked,
                                    state.gravity() * dt, dt, wall_restitution_, end_.span(), flown_.span(), notes});
    tally.end(exec, bodies, state.box(), contacts.pairs, contacts.geometry);
    std::swap(state.position, end_);
    std::swap(state.velocity, flown_);
  }

  Response response_;
  bool is_swept_;
  Real wall_restitution_;
  SweptContacts<V, Exec> swept_;
  Buffer after_;
  Buffer end_, flown_;  // where bodies are after a swept step, and their velocities
};

}  // namespace ballpit
