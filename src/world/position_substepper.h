// SPDX-License-Identifier: MIT
// A substep of the position-based response:
//
//     kick ──▶ drift ──▶ contacts there, and near ones ──▶ respond
//
// Its siblings are velocity_substepper.h and force_substepper.h.
#pragma once

#include <cmath>
#include <limits>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/contacts.h"
#include "core/span.h"
#include "integrate/symplectic_euler.h"
#include "response/impulse_notes.h"
#include "response/position_based.h"
#include "world/substepper.h"
#include "world/sums.h"

namespace ballpit {

/// Map: v² of body i.
template <class V>
struct SpeedSquared {
  Span<const V> velocity;
  HOST_DEVICE double operator()(int i) const { return double(dot(velocity[i], velocity[i])); }
};

/// For the position-based response. Spheres that do not overlap where they are predicted may come to while others are moved: so
/// near ones are contacts, too.
template <class V, class Exec>
class PositionSubstepper final : public Substepper<V, Exec> {
  using Real = Scalar<V>;

 public:
  explicit PositionSubstepper(const PositionBasedParameters& parameters) : response_(parameters) {}

  void substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Real h) override {
    Exec& exec = state.exec();
    const int64_t n = state.count();
    if (substeps_ == 0) starts_overlapping_ = overlaps(state, h) ? 1 : 0;
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
    response_.respond(state, contacts, before_.span(), h, starts_overlapping_ != 0 ? push_steps() : Real(-1), notes);
    tally.end(exec, state.bodies(), state.box(), contacts.pairs, contacts.geometry);
    ++substeps_;
  }

  std::vector<int64_t*> counters() override { return {&substeps_, &starts_overlapping_}; }

  int64_t bytes() const override { return before_.bytes() + response_.bytes(); }

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
  int64_t starts_overlapping_ = 0;  // or 1
};

template <class V, class Exec>
std::unique_ptr<Substepper<V, Exec>> make_position_based_substepper(const Scene& scene, const Settings& settings) {
  const Physics& physics = scene.physics;
  return std::make_unique<PositionSubstepper<V, Exec>>(
      PositionBasedParameters{physics.restitution, physics.wall_restitution, settings.compliance,
                              length(physics.gravity), settings.iterations.value_or(1)});
}

}  // namespace ballpit
