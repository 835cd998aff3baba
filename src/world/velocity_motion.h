// SPDX-License-Identifier: MIT
// The motion of the responses that change velocities, kinematic and impulse:
//
//     kick ──▶ contacts ──▶ respond ──▶ drift
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

  SweptContacts<V, Exec>* swept() override { return is_swept_ ? &swept_ : nullptr; }

  bool before_contacts(BodyStore<V, Exec>& bodies, Real h, int) override {
    after_.resize(bodies.count());
    kicked_ = bodies.velocity.span();
    if (is_swept_ || !bodies.has_gravity()) return false;
    bodies.exec().parallel_for("kick", bodies.count(), Kick<V>{kicked_, bodies.gravity() * h, after_.span()});
    kicked_ = after_.span();
    return false;
  }

  bool respond(BodyStore<V, Exec>& bodies, const ContactsView<V>& contacts, Real h, int,
               const ImpulseNotes<V>& notes) override {
    if (is_swept_) {
      respond_on_way(bodies, contacts, h, notes);
    } else {
      response_.respond(bodies.exec(), bodies.view(), {bodies.box(), {}}, contacts, h, kicked_, after_, notes);
    }
    return false;
  }

  bool after_contacts(BodyStore<V, Exec>& bodies, Real h, int) override {
    std::swap(bodies.velocity, is_swept_ ? flown_ : after_);
    if (is_swept_) {
      std::swap(bodies.position, end_);
    } else {
      bodies.exec().parallel_for("drift", bodies.count() * kDimensions<V>,
                                 Drift<Real>{h, components(Span<const V>(bodies.velocity.span())),
                                             components(response_.correction()), components(bodies.position.span())});
    }
    return true;
  }

  int64_t bytes() const override {
    return after_.bytes() + end_.bytes() + flown_.bytes() + response_.bytes() + swept_.bytes();
  }

 private:
  void respond_on_way(BodyStore<V, Exec>& bodies, const ContactsView<V>& contacts, Real h,
                      const ImpulseNotes<V>& notes) {
    Exec& exec = bodies.exec();
    const int64_t n = bodies.count();
    const Sweep<V> sweep = swept_.sweep();
    const Span<const V> kicked = swept_.kicked(bodies);
    response_.respond(exec, swept_.bodies(bodies), {bodies.box(), sweep}, contacts, h, kicked, after_, notes);
    end_.resize(n);
    flown_.resize(n);
    const SweptDrift<V> drift{bodies.view(),
                              bodies.box(),
                              contacts,
                              sweep,
                              after_.span(),
                              response_.correction(),
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
  Buffer after_;          // velocities after the kick, then after the response
  Span<const V> kicked_;  // velocities after the kick
  Buffer end_, flown_;    // positions and velocities after a swept step
};

}  // namespace ballpit
