// SPDX-License-Identifier: MIT
// The motion of the position-based response:
//
//     kick ──▶ drift ──▶ contacts there, and near ones ──▶ respond
//
// Spheres that do not overlap at their predicted positions may come to overlap while others are pushed apart. So spheres
// within a margin count as touching.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrate/symplectic_euler.h"
#include "response/position_based.h"
#include "world/motion.h"
#include "world/sums.h"

namespace ballpit {

/// Map: v² of body i.
template <class V>
struct SpeedSquared {
  Span<const V> velocity;
  HOST_DEVICE double operator()(int i) const { return double(dot(velocity[i], velocity[i])); }
};

template <class V, class Exec>
class PositionMotion final : public Motion<V, Exec> {
  using Real = Scalar<V>;
  using Saved = typename Motion<V, Exec>::Saved;

 public:
  /// `margin` [m].
  PositionMotion(const PositionBasedParameters& parameters, double margin)
      : response_(parameters), margin_(static_cast<Real>(margin)) {}

  /// Bodies overlap at the start if they do so by more than the motion of a substep explains: their own, and the fall that
  /// presses a heap. What a run leaves in a saved state is less, so the run goes on bit-identically.
  void start(BodyStore<V, Exec>& bodies, double overlap, Real h) override {
    constexpr double kLayers = 20;
    const Box<V>& box = bodies.box();
    const V extent = box.max - box.min, g = bodies.gravity();
    const double rounding = 32 * double(std::numeric_limits<Real>::epsilon()) * std::sqrt(double(dot(extent, extent)));
    const double speed = 2 * std::sqrt(reduce(bodies.exec(), "largest speed", bodies.count(), 0.0,
                                              SpeedSquared<V>{bodies.velocity.span()}, Largest{}));
    const double fall = kLayers * std::sqrt(double(dot(g, g))) * double(h);
    starts_overlapping_ = overlap * double(bodies.shape().smallest) > rounding + (speed + fall) * double(h);
  }

  Real margin() const override { return margin_; }
  bool can_repeat() const override { return true; }
  int64_t substeps() const override { return substeps_; }
  void go_back(int64_t substeps) override { substeps_ = substeps; }

  bool before_contacts(BodyStore<V, Exec>& bodies, Real h, int) override {
    Exec& exec = bodies.exec();
    const int64_t n = bodies.count();
    before_.resize(n);
    exec.parallel_for("note velocities", n, CopyValues<V>{bodies.velocity.span(), before_.span()});
    if (bodies.has_gravity()) {
      exec.parallel_for("kick", n, Kick<V>{before_.span(), bodies.gravity() * h, bodies.velocity.span()});
    }
    exec.parallel_for(
        "drift", n * kDimensions<V>,
        Drift<Real>{h, components(Span<const V>(bodies.velocity.span())), {}, components(bodies.position.span())});
    return true;
  }

  bool respond(BodyStore<V, Exec>& bodies, const ContactsView<V>& contacts, Real h, int,
               const ImpulseNotes<V>& notes) override {
    response_.respond(bodies, contacts, before_.span(), h, starts_overlapping_ ? push_steps() : Real(-1), notes);
    ++substeps_;
    return true;
  }

  Saved save(Exec&) override { return {{}, substeps_, starts_overlapping_}; }
  void restore(Exec&, const Saved& saved) override {
    substeps_ = saved.substeps;
    starts_overlapping_ = saved.starts_overlapping;
  }

  int64_t bytes() const override { return before_.bytes() + response_.bytes(); }

 private:
  /// Loads are carried by the overlap that a substep leaves. While overlap from the start is removed, it must not be taken
  /// for a load; then contacts may carry more from substep to substep, up to a heap of kMost layers.
  Real push_steps() const {
    constexpr Real kFirst = 2, kPerSubstep = 0.05, kMost = 100;
    const Real steps = kFirst + kPerSubstep * Real(substeps_);
    return steps < kMost ? steps : kMost;
  }

  PositionBasedResponse<V, Exec> response_;
  Real margin_;                               // [m]
  typename Exec::template Buffer<V> before_;  // velocities before the kick
  int64_t substeps_ = 0;
  bool starts_overlapping_ = false;
};

/// [m] Part of a radius, and what gravity does in a substep.
inline double contact_margin(const Scene& scene, const Settings& settings) {
  const auto& radius = scene.bodies.radius;
  if (radius.empty()) return 0;
  const double h = settings.dt / settings.substeps;
  return 0.01 * *std::max_element(radius.begin(), radius.end()) + length(scene.physics.gravity) * h * h;
}

template <class V, class Exec>
std::unique_ptr<Motion<V, Exec>> make_position_based_motion(const Scene& scene, const Settings& settings) {
  const Physics& physics = scene.physics;
  return std::make_unique<PositionMotion<V, Exec>>(
      PositionBasedParameters{physics.restitution, physics.wall_restitution, settings.compliance,
                              length(physics.gravity), settings.iterations.value_or(1)},
      contact_margin(scene, settings));
}

}  // namespace ballpit
