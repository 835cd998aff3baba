// SPDX-License-Identifier: MIT
// A substep, whole, for each kind of response: where it stands between detection and integration.
//
//     velocities   contacts ──▶ kick ──▶ respond ──▶ drift               kinematic, impulse
//     forces       integrator { candidates ──▶ forces }                    penalty
//     positions    kick ──▶ drift ──▶ contacts there, and near ones ──▶ respond         position-based
//
// Each has substep(state, tally, dt), for_each_kept(rearrange) for what it keeps for each body, and bytes().
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "simulate/integrate/symplectic_euler.h"
#include "simulate/measure.h"
#include "simulate/response/penalty.h"
#include "simulate/response/position_based.h"
#include "simulate/step_state.h"
#include "simulate/swept.h"
#include "simulate/tally_on.h"

namespace ballpit {

/// For responses that change velocities.
template <class V, class Exec, class Response>
class VelocityMotion {
  using Real = Scalar<V>;

 public:
  VelocityMotion(Response response, bool is_swept) : response_(std::move(response)), is_swept_(is_swept) {}

  void substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real dt) {
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

  template <class Rearrange>
  void for_each_kept(const Rearrange& rearrange) {
    if constexpr (requires { response_.for_each_kept(rearrange); }) response_.for_each_kept(rearrange);
  }

  int64_t bytes() const { return after_.bytes() + response_.bytes() + swept_.bytes(); }

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
  typename Exec::template Buffer<V> after_;
};

/// For the penalty response, by any integrator.
template <class V, class Exec, class Integrator>
class ForceMotion {
  using Real = Scalar<V>;

 public:
  explicit ForceMotion(const PenaltyLaw<Real>& law) : response_(law) {}

  void substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real dt) {
    Forces forces{response_, tally};
    integrator_.step(state, forces, dt);
  }

  double elastic_energy(StepState<V, Exec>& state) const {
    return response_.elastic_energy(state.exec(), state.bodies(), state.box(), state.pairs());
  }

  template <class Rearrange>
  void for_each_kept(const Rearrange& rearrange) {
    if constexpr (requires { integrator_.for_each_kept(rearrange); }) integrator_.for_each_kept(rearrange);
  }

  int64_t bytes() const { return response_.bytes() + integrator_.bytes(); }

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

/// Map: v² of body i.
template <class V>
struct SpeedSquared {
  Span<const V> velocity;
  HOST_DEVICE double operator()(int i) const { return double(dot(velocity[i], velocity[i])); }
};

/// For the position-based response. Spheres that do not overlap where they are predicted may come to while others are moved: so
/// near ones are contacts, too.
template <class V, class Exec>
class PositionMotion {
  using Real = Scalar<V>;

 public:
  explicit PositionMotion(const PositionBasedParameters& parameters) : response_(parameters) {}

  void substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real h) {
    Exec& exec = state.exec();
    const int64_t n = state.count();
    if (substeps_ == 0) starts_overlapping_ = overlaps(state, h);
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
    response_.respond(state, contacts, before_.span(), h, starts_overlapping_ ? push_steps() : Real(-1), notes);
    tally.end(exec, state.bodies(), state.box(), contacts.pairs, contacts.geometry);
    ++substeps_;
  }

  template <class Rearrange>
  void for_each_kept(const Rearrange&) {}

  /// Calls visit(value) for what a snapshot holds beside it.
  template <class Visit>
  void for_each_saved(const Visit& visit) {
    visit(substeps_);
    visit(starts_overlapping_);
  }

  int64_t bytes() const { return before_.bytes() + response_.bytes(); }

 private:
  /// Whether anything overlaps by more than the motion of a substep explains: the bodies' own, and the fall that presses a
  /// heap. What a run leaves in a saved state is less, and it goes on by the same bits.
  static bool overlaps(StepState<V, Exec>& state, Real h) {
    constexpr double kLayers = 20;
    const Box<V>& box = state.box();
    const V extent = box.max - box.min;
    const double rounding = 32 * double(std::numeric_limits<Real>::epsilon()) * std::sqrt(double(dot(extent, extent)));
    const double largest = largest_overlap(state.exec(), state.bodies(), box, state.near_pairs().pairs);
    const double speed = 2 * std::sqrt(reduce(state.exec(), "largest speed", state.count(), 0.0,
                                              SpeedSquared<V>{state.velocity.span()}, Largest{}));
    const double fall = kLayers * std::sqrt(double(dot(state.gravity(), state.gravity()))) * double(h);
    return largest * double(state.shape().smallest) > rounding + (speed + fall) * double(h);
  }

  /// Loads are carried by overlap that a substep leaves. While that which was there at the start is removed, it is not to be
  /// taken for such; then contacts may carry more from substep to substep, up to a heap of kPushSteps layers.
  Real push_steps() const {
    constexpr Real kFirst = 2, kPerSubstep = 0.05, kPushSteps = 100;
    const Real steps = kFirst + kPerSubstep * Real(substeps_);
    return steps < kPushSteps ? steps : kPushSteps;
  }

  PositionBasedResponse<V, Exec> response_;
  typename Exec::template Buffer<V> before_;
  int64_t substeps_ = 0;
  bool starts_overlapping_ = false;
};

}  // namespace ballpit
