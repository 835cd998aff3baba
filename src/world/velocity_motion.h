// SPDX-License-Identifier: MIT
// The motion of the responses that change velocities, kinematic and impulse:
//
//     contacts ──▶ kick, respond ──▶ drift
//     kick ──▶ contacts on the way ──▶ respond ──▶ drift        where contacts are swept: swept.h
#pragma once

#include "integrate/symplectic_euler.h"
#include "world/motion.h"
#include "world/swept.h"
#include "world/swept_drift.h"

namespace ballpit {

template <class V, class Exec, class Response>
class VelocityMotion final : public Motion<V, Exec> {
  using Real = Scalar<V>;
  using Buffer = typename Exec::template Buffer<V>;

 public:
  /// `wall_restitution` is needed where contacts are swept.
  VelocityMotion(Response response, bool is_swept, double wall_restitution)
      : response_(std::move(response)), is_swept_(is_swept), wall_restitution_(static_cast<Real>(wall_restitution)) {}

  bool can_repeat() const override { return !is_swept_; }
  SweptContacts<V, Exec>* swept() override { return is_swept_ ? &swept_ : nullptr; }

  bool before_contacts(BodyStore<V, Exec>& bodies, Real h, int) override {
    after_.resize(bodies.count());
    kick_ = bodies.gravity() * h;
    return false;
  }

  bool respond(BodyStore<V, Exec>& bodies, const ContactsView<V>& contacts, Real h, int,
               const ImpulseNotes<V>& notes) override {
    if (is_swept_) {
      respond_on_way(bodies, contacts, h, notes);
    } else {
      response_.respond(bodies.exec(), bodies.view(), {bodies.box(), {}}, contacts, h,
                        {bodies.velocity.span(), kick_, bodies.has_gravity()}, after_, notes);
    }
    return false;
  }

  bool after_contacts(BodyStore<V, Exec>& bodies, Real h, int) override {
    std::swap(bodies.velocity, is_swept_ ? flown_ : after_);
    if (is_swept_) {
      std::swap(bodies.position, end_);
    } else {
      drift(bodies.exec(), h, bodies.velocity.span(), bodies.position.span());
    }
    return true;
  }

  int64_t bytes() const override {
    return after_.bytes() + end_.bytes() + flown_.bytes() + response_.bytes() + swept_.bytes();
  }

 private:
  void drift(Exec& exec, Real h, Span<const V> velocity, Span<V> position) {
    if constexpr (requires { response_.drift(exec, h, velocity, position); }) {
      response_.drift(exec, h, velocity, position);
    } else {
      exec.parallel_for(
          "drift", position.size() * kDimensions<V>,
          Drift<Real>{h, components(velocity), components(response_.correction(exec)), components(position)});
    }
  }

  void respond_on_way(BodyStore<V, Exec>& bodies, const ContactsView<V>& contacts, Real h,
                      const ImpulseNotes<V>& notes) {
    Exec& exec = bodies.exec();
    const int64_t n = bodies.count();
    const Sweep<V> sweep = swept_.sweep();
    const Span<const V> kicked = swept_.kicked(bodies);
    response_.respond(exec, swept_.bodies(bodies), {bodies.box(), sweep}, contacts, h, {kicked}, after_, notes);
    end_.resize(n);
    flown_.resize(n);
    const SweptDrift<V> drift{bodies.view(),
                              bodies.box(),
                              contacts,
                              sweep,
                              after_.span(),
                              response_.correction(exec),
                              kicked,
                              bodies.gravity() * h,
                              h,
                              wall_restitution_,
                              end_.span(),
                              flown_.span(),
                              notes};
    if (notes.are_kept() && !bodies.box().is_periodic()) {
      exec.parallel_for("count hits of walls", n, CountWallHits<V>{drift, notes.wall_hits});
    }
    exec.parallel_for("swept drift", n, drift);
  }

  Response response_;
  bool is_swept_;
  Real wall_restitution_;
  SweptContacts<V, Exec> swept_;
  V kick_{};            // [m/s] of a substep
  Buffer after_;        // velocities after the response
  Buffer end_, flown_;  // positions and velocities after a swept step
};

}  // namespace ballpit
