// SPDX-License-Identifier: MIT
// Stops a run that has gone wrong. Every step: a sphere that is not finite or outside the domain. Every kSteps-th step: an
// overlap or an energy beyond its limit. A state that passes is stored as the last good one.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/pair.h"
#include "core/error.h"
#include "core/span.h"
#include "world/body_store.h"
#include "world/sums.h"

namespace ballpit {

/// Map: an amount of overlap or energy, and the pair or body that has it.
struct Offender {
  double amount = -1;
  int64_t first = -1, second = -1;  ///< slots; second −1: a wall, or none
};
struct WorseOffender {
  HOST_DEVICE Offender operator()(const Offender& a, const Offender& b) const { return a.amount < b.amount ? b : a; }
};

template <class V>
struct OverlapOffender {
  PairOverlap<V> overlap;
  HOST_DEVICE Offender operator()(int k) const { return {overlap(k), overlap.pairs[k].i, overlap.pairs[k].j}; }
};
template <class V>
struct WallOffender {
  WallOverlap<V> overlap;
  HOST_DEVICE Offender operator()(int i) const { return {overlap(i), i, -1}; }
};

/// Predicate: pair k overlaps by about `limit` of the smaller radius, or more.
template <class V>
struct MayOverlapTooMuch {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const Pair> pairs;
  Real limit;

  HOST_DEVICE bool operator()(int k) const {
    const Pair pair = pairs[k];
    const V d = box.displacement(bodies.position[pair.i], bodies.position[pair.j]);
    const Real ri = bodies.radius[pair.i], rj = bodies.radius[pair.j];
    const Real reach = (ri + rj - limit * (ri < rj ? ri : rj)) * Real(1.00001);  // rounding must not hide an overlap
    return !((reach <= 0) | (dot(d, d) > reach * reach));
  }
};

/// Predicate: body i overlaps a wall by more than `limit` of its radius.
template <class V>
struct OverlapsWallTooMuch {
  WallOverlap<V> overlap;
  double limit;
  HOST_DEVICE bool operator()(int i) const { return overlap(i) > limit; }
};

/// Map: the kinetic energy of body i.
template <class V>
struct EnergyOffender {
  EnergyAndMomentumOf<V> motion;
  HOST_DEVICE Offender operator()(int i) const { return {motion(i).kinetic, i, -1}; }
};

/// Map: the energy that body i may have without a cause [J].
template <class V>
struct LeastEnergy {
  BodiesView<V> bodies;
  double gravity;  ///< [m/s²]
  double rounded;  ///< [J/kg]
  HOST_DEVICE double operator()(int i) const {
    return (gravity * double(bodies.radius[i]) + rounded) / double(bodies.inverse_mass[i]);
  }
};

template <class V, class Exec>
class Guard {
  using Buffer = typename Exec::template Buffer<V>;

 public:
  /// What a snapshot holds of the guard. Where the last good state is the present one, it is held once, by the bodies.
  struct Saved {
    double max_overlap = 0, overlap_at_start = 0, energy_at_start = 0, explained = 0, good_time = 0;
    bool is_started = false, is_present_good = false;
    std::vector<V> good_position, good_velocity;
  };

  /// `h` [s]: length of a substep. `hint`: what helps against too much overlap, and against spheres that leave.
  Guard(double max_overlap, double max_energy, double h, std::string hint)
      : max_overlap_(max_overlap), max_energy_(max_energy), h_(h), hint_(std::move(hint)) {}

  /// Call before the first step. `near` are pairs that include all contacts; `elastic` is the energy in springs [J].
  void start(const BodyStore<V, Exec>& bodies, Span<const Pair> near, double elastic) {
    overlap_at_start_ = worst_overlap(bodies, near).amount;
    max_overlap_ = std::fmax(max_overlap_, 2 * overlap_at_start_);  // overlap at the start may settle
    energy_at_start_ = energy(bodies) + elastic;
    explained_ = std::fmax(energy_at_start_, least_energy(bodies));
    keep(bodies, 0);
  }

  bool is_started() const { return good_position_.size() > 0; }
  double overlap_at_start() const { return overlap_at_start_; }  ///< of the smaller radius; −1: nothing touches

  /// Whether check() is to be called after this step.
  static bool is_due(int64_t step) { return step % kSteps == 0; }

  /// Throws RunError where a body is not a number, or outside the domain.
  void check_inside(const BodyStore<V, Exec>& bodies, int64_t step, double time) const {
    const int64_t bad = first_outside(bodies.exec(), bodies.view(), bodies.box(), bodies.order().id_at());
    if (bad < 0) return;
    const Vec3d p = widen(bodies.downloaded(bodies.position)[static_cast<size_t>(bad)]);
    std::ostringstream message;
    message << "sphere " << bad << " left the domain: its centre is at (" << p.x << ", " << p.y << ", " << p.z << ")";
    stop(step, time, message.str(), hint_);
  }

  /// Throws RunError where overlap or energy are beyond their limits; else the state is the last good one. `near` are pairs
  /// that include all contacts.
  void check(const BodyStore<V, Exec>& bodies, Span<const Pair> near, int64_t step, double time) {
    check_overlap(bodies, near, step, time);
    check_energy(bodies, step, time);
    keep(bodies, time);
  }

  Bodies last_good(const BodyStore<V, Exec>& bodies) const { return bodies.download(good_position_, good_velocity_); }
  double last_good_time() const { return good_time_; }  ///< [s]

  /// The last good state, by slot.
  std::array<Buffer*, 2> kept() { return {&good_position_, &good_velocity_}; }

  /// The guard of `bodies` at `time` [s].
  Saved save(const BodyStore<V, Exec>& bodies, double time) const {
    Saved saved{max_overlap_, overlap_at_start_, energy_at_start_, explained_, good_time_, is_started(), false, {}, {}};
    saved.is_present_good = saved.is_started && good_time_ == time;
    if (!saved.is_present_good) {
      saved.good_position = bodies.exec().download(good_position_.span());
      saved.good_velocity = bodies.exec().download(good_velocity_.span());
    }
    return saved;
  }

  /// `bodies` are those of the snapshot.
  void restore(const BodyStore<V, Exec>& bodies, const Saved& saved) {
    max_overlap_ = saved.max_overlap;
    overlap_at_start_ = saved.overlap_at_start;
    energy_at_start_ = saved.energy_at_start;
    explained_ = saved.explained;
    if (saved.is_present_good) {
      keep(bodies, saved.good_time);
    } else {
      bodies.exec().upload(good_position_, saved.good_position);
      bodies.exec().upload(good_velocity_, saved.good_velocity);
      good_time_ = saved.good_time;
    }
  }

  int64_t bytes() const { return good_position_.bytes() + good_velocity_.bytes(); }

 private:
  static constexpr int64_t kSteps = 16;

  [[noreturn]] static void stop(int64_t step, double time, const std::string& what, const std::string& hint) {
    std::ostringstream where;
    where << "step " << step << " (t = " << time << " s)";
    throw RunError(where.str(), what, hint);
  }

  static Offender worst_overlap(const BodyStore<V, Exec>& state, Span<const Pair> pairs) {
    const BodiesView<V> bodies = state.view();
    const PairOverlap<V> of_pair{bodies, state.box(), pairs};
    const Offender spheres =
        reduce(state.exec(), "check overlap", pairs.size(), Offender{}, OverlapOffender<V>{of_pair}, WorseOffender{});
    if (state.box().is_periodic()) return spheres;
    const Offender walls = reduce(state.exec(), "check overlap", bodies.size(), Offender{},
                                  WallOffender<V>{{bodies, state.box()}}, WorseOffender{});
    return WorseOffender{}(spheres, walls);
  }

  bool may_overlap_too_much(const BodyStore<V, Exec>& state, Span<const Pair> pairs) const {
    const BodiesView<V> bodies = state.view();
    const MayOverlapTooMuch<V> of_pair{bodies, state.box(), pairs, static_cast<Scalar<V>>(max_overlap_)};
    const OverlapsWallTooMuch<V> of_wall{{bodies, state.box()}, max_overlap_};
    return any(state.exec(), "check overlap", pairs.size(), of_pair) ||
           (!state.box().is_periodic() && any(state.exec(), "check overlap", bodies.size(), of_wall));
  }

  void check_overlap(const BodyStore<V, Exec>& state, Span<const Pair> near, int64_t step, double time) const {
    if (!may_overlap_too_much(state, near)) return;
    const Offender worst = worst_overlap(state, near);
    if (!(worst.amount > max_overlap_)) return;
    std::ostringstream message;
    message << "sphere " << id(state, worst.first);
    if (worst.second >= 0) {
      message << " overlaps sphere " << id(state, worst.second) << " by ";
    } else {
      message << " overlaps a wall by ";
    }
    message << worst.amount << " of the smaller radius, more than --max-overlap " << max_overlap_;
    stop(step, time, message.str(), hint_);
  }

  /// Springs are left out: spurious energy does not stay in them.
  void check_energy(const BodyStore<V, Exec>& state, int64_t step, double time) const {
    if (state.box().is_periodic() && state.has_gravity()) return;  // falls forever
    const double now = energy(state);
    if (now <= max_energy_ * explained_) return;
    const Offender fastest = reduce(state.exec(), "check energy", state.count(), Offender{},
                                    EnergyOffender<V>{{state.view(), state.gravity()}}, WorseOffender{});
    std::ostringstream message;
    message << "the energy is ";
    if (energy_at_start_ > 0) {
      message << now / energy_at_start_ << " times that at the start";
    } else {
      message << now << " J, and was 0 J at the start";
    }
    message << ", more than --max-energy " << max_energy_ << "; sphere " << id(state, fastest.first)
            << " has most of it, " << fastest.amount << " J";
    stop(step, time, message.str(),
         overlap_at_start_ > kOverlapThatMatters ? "less overlap at the start may help"
                                                 : "a smaller --dt or more --substeps may help");
  }

  /// [J] The energy that a run may have even if it starts with less: from lifting spheres by their radius, as out of the
  /// floor, and from rounding positions in a substep.
  double least_energy(const BodyStore<V, Exec>& state) const {
    const V extent = state.box().max - state.box().min, g = state.gravity();
    const double speed = 64 * double(std::numeric_limits<Scalar<V>>::epsilon()) * length(widen(extent)) / h_;
    return reduce(state.exec(), "check energy", state.count(), 0.0,
                  LeastEnergy<V>{state.view(), length(widen(g)), 0.5 * speed * speed}, Sum{});
  }

  /// [J] kinetic, and potential above the lowest corner of the domain.
  static double energy(const BodyStore<V, Exec>& state) {
    const EnergyAndMomentum sum =
        reduce(state.exec(), "check energy", state.count(), EnergyAndMomentum{},
               EnergyAndMomentumOf<V>{state.view(), state.gravity(), lowest_corner(state)}, Sum{});
    return sum.kinetic + sum.potential;
  }

  static V lowest_corner(const BodyStore<V, Exec>& state) {
    V corner{};
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      corner[axis] = state.gravity()[axis] < 0 ? state.box().min[axis] : state.box().max[axis];
    }
    return corner;
  }

  static int64_t id(const BodyStore<V, Exec>& state, int64_t place) {
    const Span<const int> id_at = state.order().id_at();
    return id_at.empty() ? place : state.exec().download(id_at)[static_cast<size_t>(place)];
  }

  void keep(const BodyStore<V, Exec>& state, double time) {
    const int64_t n = state.count();
    good_position_.resize(n);
    good_velocity_.resize(n);
    state.exec().parallel_for("keep state", n, CopyValues<V>{state.position.span(), good_position_.span()});
    state.exec().parallel_for("keep state", n, CopyValues<V>{state.velocity.span(), good_velocity_.span()});
    good_time_ = time;
  }

  static constexpr double kOverlapThatMatters = 0.001;  // of the smaller radius

  double max_overlap_, max_energy_, h_;
  std::string hint_;
  double overlap_at_start_ = 0, energy_at_start_ = 0;
  double explained_ = 0;  // [J] --max-energy is a multiple of it
  Buffer good_position_, good_velocity_;
  double good_time_ = 0;
};

}  // namespace ballpit
