// SPDX-License-Identifier: MIT
// Looks after a run: a sphere that is not a number or outside the domain stops it at once; in every kSteps-th step so do an
// overlap or an energy beyond their limits. A state that passes is kept as the last good one.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "core/error.h"
#include "simulate/measure.h"
#include "simulate/step_state.h"

namespace ballpit {

/// Map: a fraction of overlap and the pair, or body and wall, that has it.
struct Offender {
  double amount = -1;
  int64_t first = -1, second = -1;  ///< places of bodies; second −1: a wall, or nobody
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
    const Real reach = (ri + rj - limit * (ri < rj ? ri : rj)) * Real(1.00001);  // rounding must not hide one
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

/// Map: kinetic energy of body i, and who has it.
template <class V>
struct EnergyOffender {
  MotionOf<V> motion;
  HOST_DEVICE Offender operator()(int i) const { return {motion(i).kinetic, i, -1}; }
};

template <class V, class Exec>
class Guard {
  using Buffer = typename Exec::template Buffer<V>;

 public:
  Guard(double max_overlap, double max_energy) : max_overlap_(max_overlap), max_energy_(max_energy) {}

  /// To be called before the first step. `elastic` is the energy in springs [J].
  void start(StepState<V, Exec>& state, double elastic) {
    max_overlap_ = std::fmax(max_overlap_, 2 * worst_overlap(state).amount);  // a start may overlap, and settles
    energy_at_start_ = energy(state) + elastic;
    keep(state, 0);
  }

  bool is_started() const { return good_position_.size() > 0; }

  /// Whether check() is to be called after this step.
  static bool is_due(int64_t step) { return step % kSteps == 0; }

  /// Throws RunError where a body is not a number, or outside the domain. In every step. A body that is in its skin, and
  /// whose skin is inside, is inside.
  void check_inside(StepState<V, Exec>& state, int64_t step, double time) const {
    if (!is_due(step) && state.shows_all_inside()) return;  // velocities are looked at when check() is due
    const int64_t bad = first_outside(state.exec(), state.bodies(), state.box(), state.order().id_at());
    if (bad < 0) return;
    const Vec3d p = widen(state.downloaded(state.position)[static_cast<size_t>(bad)]);
    std::ostringstream message;
    message << "sphere " << bad << " left the domain: its centre is at (" << p.x << ", " << p.y << ", " << p.z << ")";
    stop(step, time, message.str());
  }

  /// Throws RunError where overlap or energy are beyond their limits; else the state is the last good one.
  void check(StepState<V, Exec>& state, int64_t step, double time) {
    check_overlap(state, step, time);
    check_energy(state, step, time);
    keep(state, time);
  }

  Bodies last_good(const StepState<V, Exec>& state) const { return state.download(good_position_, good_velocity_); }
  double last_good_time() const { return good_time_; }  ///< [s]

  /// Calls rearrange(values) for what is kept for each body.
  template <class Rearrange>
  void for_each_kept(const Rearrange& rearrange) {
    rearrange(good_position_);
    rearrange(good_velocity_);
  }

  /// Calls visit(value) for all that a snapshot of `state` at `time` holds. Where the last good state is this one, it is
  /// held once: each 16th step's snapshot is half as large.
  template <class Visit>
  void for_each_saved(StepState<V, Exec>& state, double time, const Visit& visit) {
    bool is_now = is_started() && good_time_ == time;
    visit(is_now);
    visit(max_overlap_);
    visit(energy_at_start_);
    visit(good_time_);
    if (is_now) {
      keep(state, good_time_);  // where it is put back; else it is kept already
    } else {
      for_each_kept(visit);
    }
  }

  int64_t bytes() const { return good_position_.bytes() + good_velocity_.bytes(); }

 private:
  static constexpr int64_t kSteps = 16;

  [[noreturn]] static void stop(int64_t step, double time, const std::string& what) {
    std::ostringstream message;
    message << "step " << step << " (t = " << time << " s): " << what << "; a smaller --dt or more --substeps may help";
    throw RunError(message.str());
  }

  static Offender worst_overlap(StepState<V, Exec>& state) {
    const BodiesView<V> bodies = state.bodies();
    const Span<const Pair> pairs = state.near_pairs().pairs;
    const PairOverlap<V> of_pair{bodies, state.box(), pairs};
    const Offender spheres =
        reduce(state.exec(), "check overlap", pairs.size(), Offender{}, OverlapOffender<V>{of_pair}, WorseOffender{});
    if (state.box().is_periodic()) return spheres;
    const Offender walls = reduce(state.exec(), "check overlap", bodies.size(), Offender{},
                                  WallOffender<V>{{bodies, state.box()}}, WorseOffender{});
    return WorseOffender{}(spheres, walls);
  }

  bool may_overlap_too_much(StepState<V, Exec>& state) const {
    const BodiesView<V> bodies = state.bodies();
    const Span<const Pair> pairs = state.near_pairs().pairs;
    const MayOverlapTooMuch<V> of_pair{bodies, state.box(), pairs, static_cast<Scalar<V>>(max_overlap_)};
    const OverlapsWallTooMuch<V> of_wall{{bodies, state.box()}, max_overlap_};
    return any(state.exec(), "check overlap", pairs.size(), of_pair) ||
           (!state.box().is_periodic() && any(state.exec(), "check overlap", bodies.size(), of_wall));
  }

  void check_overlap(StepState<V, Exec>& state, int64_t step, double time) const {
    if (!may_overlap_too_much(state)) return;
    const Offender worst = worst_overlap(state);
    if (!(worst.amount > max_overlap_)) return;
    std::ostringstream message;
    message << "sphere " << id(state, worst.first);
    if (worst.second >= 0) {
      message << " overlaps sphere " << id(state, worst.second) << " by ";
    } else {
      message << " overlaps a wall by ";
    }
    message << worst.amount << " of the smaller radius, more than --max-overlap " << max_overlap_;
    stop(step, time, message.str());
  }

  /// Springs are left out: energy from nowhere does not stay in them.
  void check_energy(StepState<V, Exec>& state, int64_t step, double time) const {
    if (state.box().is_periodic() && state.has_gravity()) return;  // falls for ever
    const double now = energy(state);
    if (!(energy_at_start_ > 0) || now <= max_energy_ * energy_at_start_) return;
    const Offender fastest = reduce(state.exec(), "check energy", state.count(), Offender{},
                                    EnergyOffender<V>{{state.bodies(), state.gravity()}}, WorseOffender{});
    std::ostringstream message;
    message << "the energy is " << now / energy_at_start_ << " times that at the start, more than --max-energy "
            << max_energy_ << "; sphere " << id(state, fastest.first) << " has most of it, " << fastest.amount << " J";
    stop(step, time, message.str());
  }

  /// [J] kinetic, and potential above the lowest corner of the domain.
  static double energy(StepState<V, Exec>& state) {
    const Motion sum = reduce(state.exec(), "check energy", state.count(), Motion{},
                              MotionOf<V>{state.bodies(), state.gravity(), lowest_corner(state)}, Sum{});
    return sum.kinetic + sum.potential;
  }

  static V lowest_corner(const StepState<V, Exec>& state) {
    V corner{};
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      corner[axis] = state.gravity()[axis] < 0 ? state.box().min[axis] : state.box().max[axis];
    }
    return corner;
  }

  static int64_t id(StepState<V, Exec>& state, int64_t place) {
    const Span<const int> id_at = state.order().id_at();
    return id_at.empty() ? place : state.exec().download(id_at)[static_cast<size_t>(place)];
  }

  void keep(StepState<V, Exec>& state, double time) {
    const int64_t n = state.count();
    good_position_.resize(n);
    good_velocity_.resize(n);
    state.exec().parallel_for("keep state", n, CopyValues<V>{state.position.span(), good_position_.span()});
    state.exec().parallel_for("keep state", n, CopyValues<V>{state.velocity.span(), good_velocity_.span()});
    good_time_ = time;
  }

  double max_overlap_, max_energy_, energy_at_start_ = 0;
  Buffer good_position_, good_velocity_;
  double good_time_ = 0;
};

}  // namespace ballpit
