// SPDX-License-Identifier: MIT
// A substep of the responses that change velocities, kinematic and impulse:
//
//     contacts ──▶ kick ──▶ respond ──▶ drift
//
// Its siblings are force_substepper.h and position_substepper.h.
#pragma once

#include <utility>

#include "simulate/integrate/symplectic_euler.h"
#include "simulate/substepper.h"
#include "simulate/swept.h"

namespace ballpit {

template <class V, class Exec, class Response>
class VelocitySubstepper final : public Substepper<V, Exec> {
  using Real = Scalar<V>;
  using Buffer = typename Exec::template Buffer<V>;

 public:
  VelocitySubstepper(Response response, bool is_swept) : response_(std::move(response)), is_swept_(is_swept) {}

  void substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real dt) override {
    Exec& exec = state.exec();
    const int64_t n = state.count();
    const BodiesView<V> bodies = state.bodies();
    after_.resize(n);
    Span<const V> kicked = bodies.velocity;
    if (state.has_gravity()) {
      exec.parallel_for("kick", n, Kick<V>{bodies.velocity, state.gravity() * dt, after_.span()});
      kicked = after_.span();
    }
    const ContactsView<V> contacts = is_swept_ ? swept_.find(state, kicked, dt) : state.contacts();
    const ImpulseNotes<V> notes = tally.begin(exec, n, contacts.pairs.size());
    response_.respond(exec, bodies, {state.box(), swept_.way()}, contacts, dt, kicked, after_, notes);
    tally.end(exec, bodies, state.box(), contacts.pairs, contacts.geometry);
    std::swap(state.velocity, after_);
    drift(state, contacts, dt);
    state.moved();
  }

  std::vector<Buffer*> kept() override {
    if constexpr (requires { response_.kept(); }) return {response_.kept()};
    return {};
  }

  int64_t bytes() const override { return after_.bytes() + response_.bytes() + swept_.bytes(); }

 private:
  void drift(StepState<V, Exec>& state, const ContactsView<V>& contacts, Real dt) {
    const Span<V> position = state.position.span();
    const Span<const V> velocity = state.velocity.span();
    if (is_swept_) {
      state.exec().parallel_for("swept drift", state.count(),
                                SweptDrift<V>{state.bodies(), state.box(), contacts, swept_.time(), swept_.way(),
                                              velocity, response_.correction(), dt, position});
    } else {
      state.exec().parallel_for(
          "drift", state.count() * kDimensions<V>,
          Drift<Real>{dt, components(velocity), components(response_.correction()), components(position)});
    }
  }

  Response response_;
  bool is_swept_;
  SweptContacts<V, Exec> swept_;
  Buffer after_;
};

}  // namespace ballpit
