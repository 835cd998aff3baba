// SPDX-License-Identifier: MIT
// Contacts along the step: a sphere that would pass another, or a wall, within one step is stopped where they meet.
//
//      ╭───────────────╮       the broad phase sees the sphere around each way: its middle, radius r + |way|/2
//      │ ○╌╌╌╌╌╌╌╌╌▸○  │       |d + v·t| = r_i + r_j,  d, v relative:  t = c / (−b + √(b² − a·c)) with
//      ╰───────────────╯       a = v·v, b = d·v, c = d·d − (r_i + r_j)²  – no difference of like numbers
//
// A pair with t in [0, dt] is a contact, with the normal that it has at t. Each body moves with its old velocity up to its
// first contact, and on with the one that the response gives it. So the first hit of a body in a step cannot be missed, and
// no body leaves through a wall; a second hit in the same step is found by the next one, if the bodies still overlap then.
// Cost: the broad phase among larger spheres, O(candidates + n). Source: Ericson, "Real-Time Collision Detection" (2005),
// section 5.5.5.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "core/error.h"
#include "exec/reduce.h"
#include "simulate/measure.h"
#include "simulate/narrowphase/contact_list.h"
#include "simulate/step_state.h"

namespace ballpit {

/// Kernel: the way of body i, and the sphere around it.
template <class V>
struct SweepBody {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const V> velocity;
  Real dt;
  Span<V> way, middle;
  Span<Real> reach;

  HOST_DEVICE void operator()(int i) const {
    const V w = velocity[i] * dt;
    way[i] = w;
    middle[i] = box.wrap(bodies.position[i] + w / Real(2));
    reach[i] = bodies.radius[i] + std::sqrt(dot(w, w)) / 2 * Real(1.00001);  // rounding must not shorten it
  }
};

/// Map: the largest reach.
template <class Real>
struct ReachAt {
  Span<const Real> reach;
  HOST_DEVICE double operator()(int i) const { return double(reach[i]); }
};

/// When and how two bodies meet.
template <class V>
struct Impact {
  Scalar<V> time;  ///< as a fraction of the step; above 1: not in this one
  V apart;         ///< from i to j, then [m]
};

/// The first time in the step at which two bodies touch.
template <class V>
struct FindImpact {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const V> way, middle;

  HOST_DEVICE Impact<V> operator()(const Pair& pair) const {
    const V w = way[pair.j] - way[pair.i];
    const V d = box.displacement(middle[pair.i], middle[pair.j]) - w / Real(2);  // the images that meet
    const Real radii = bodies.radius[pair.i] + bodies.radius[pair.j];
    const Real c = dot(d, d) - radii * radii;
    if (c <= 0) return {Real(0), d};
    const Real a = dot(w, w), b = dot(d, w), root = b * b - a * c;
    if (!(b < 0) || root < 0) return {Real(2), d};
    const Real t = c / (-b + std::sqrt(root));
    return {t, d + w * t};
  }
};

/// Kernel: 1 for pairs that meet in the step.
template <class V>
struct MarkImpact {
  FindImpact<V> find;
  Span<const Pair> pairs;
  Span<int> is_hit;
  HOST_DEVICE void operator()(int k) const { is_hit[k] = find(pairs[k]).time <= 1; }
};

/// Kernel: keeps the pairs that are marked, in their order.
struct KeepMarked {
  Span<const Pair> pairs;
  Span<const int> place;  ///< one more than pairs
  Span<Pair> kept;
  HOST_DEVICE void operator()(int k) const {
    if (place[k + 1] > place[k]) kept[place[k]] = pairs[k];
  }
};

/// Kernel: where the kept pairs of body i begin.
struct KeepRows {
  Span<const int> first, place;
  Span<int> kept;
  HOST_DEVICE void operator()(int i) const { kept[i] = place[first[i]]; }
};

/// Kernel: contact c as it is when its bodies meet.
template <class V>
struct MeasureImpact {
  using Real = Scalar<V>;
  FindImpact<V> find;
  Span<const Pair> pairs;
  Span<ContactGeometry<V>> geometry;
  Span<Real> time;

  HOST_DEVICE void operator()(int c) const {
    const Pair pair = pairs[c];
    const Impact<V> impact = find(pair);
    time[c] = impact.time;
    if (impact.time <= 0) return;  // they overlap already, and were measured so
    const V normal = impact.apart / std::sqrt(dot(impact.apart, impact.apart));
    geometry[c] = {normal, Real(0), dot(find.bodies.velocity[pair.j] - find.bodies.velocity[pair.i], normal)};
  }
};

/// Kernel: body i moves with its old velocity up to its first contact, then with the new one, and not through a wall.
template <class V>
struct SweptDrift {
  using Real = Scalar<V>;
  BodiesView<V> bodies;  ///< before the drift
  Box<V> box;
  ContactsView<V> contacts;
  Span<const Real> time;  ///< of each contact
  Span<const V> way;
  Span<const V> velocity;    ///< the new one
  Span<const V> correction;  ///< [m]
  Real dt;
  Span<V> position;

  HOST_DEVICE void operator()(int i) const {
    const V p = bodies.position[i];
    const Real radius = bodies.radius[i];
    Real first = 1;
    bool is_free = true;
    contacts.for_each_of(i, [&](int c, int, int) { meet(time[c], first, is_free); });
    box.for_each_wall_on_way(p, p + way[i], radius, [&](int axis, int side, Real overlap) {
      const Real gap = (side < 0 ? p[axis] - box.min[axis] : box.max[axis] - p[axis]) - radius;
      meet(overlap > 0 || gap <= 0 ? Real(0) : gap / std::fabs(way[i][axis]), first, is_free);
    });
    const Real before = is_free ? Real(1) : first;
    V end = p + way[i] * before + velocity[i] * ((1 - before) * dt) + correction[i];
    if (!box.is_periodic()) keep_inside(p, radius, end);
    position[i] = end;
  }

 private:
  HOST_DEVICE static void meet(Real time, Real& first, bool& is_free) {
    is_free = false;
    if (time < first) first = time;
  }

  /// A sphere that did not overlap a wall does not after its way, either.
  HOST_DEVICE void keep_inside(const V& p, Real radius, V& end) const {
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const Real low = box.min[axis] + radius, high = box.max[axis] - radius;
      const Real least = p[axis] < low ? p[axis] : low, most = p[axis] > high ? p[axis] : high;
      if (end[axis] < least) end[axis] = least;
      if (end[axis] > most && !(axis == 1 && box.boundary == Boundary::open_top)) end[axis] = most;
    }
  }
};

template <class V, class Exec>
class SweptContacts {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// The contacts of a step of dt that begins at the state's positions, with these velocities.
  ContactsView<V> find(StepState<V, Exec>& state, Span<const V> velocity, Real dt) {
    Exec& exec = state.exec();
    const BodiesView<V> bodies = state.bodies();
    sweep(exec, bodies, state.box(), velocity, dt);
    search(state);
    keep_impacts(exec, bodies, state.box());
    list_.build(exec, pairs_.span(), first_.span(), bodies, state.box());
    time_.resize(pairs_.size());
    exec.parallel_for("measure impacts", pairs_.size(),
                      MeasureImpact<V>{finder(bodies, state.box()), pairs_.span(), list_.geometry(), time_.span()});
    return list_.view();
  }

  /// What each body is about to go [m], and when the contacts are met [of the step]; after find().
  Span<const V> way() const { return way_.span(); }
  Span<const Real> time() const { return time_.span(); }

  int64_t bytes() const {
    return way_.bytes() + middle_.bytes() + reach_.bytes() + is_hit_.bytes() + place_.bytes() + first_.bytes() +
           pairs_.bytes() + time_.bytes() + detector_.bytes();
  }

 private:
  FindImpact<V> finder(const BodiesView<V>& bodies, const Box<V>& box) const {
    return {bodies, box, way_.span(), middle_.span()};
  }

  void sweep(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, Span<const V> velocity, Real dt) {
    const int64_t n = bodies.size();
    way_.resize(n);
    middle_.resize(n);
    reach_.resize(n);
    exec.parallel_for("sweep bodies", n,
                      SweepBody<V>{bodies, box, velocity, dt, way_.span(), middle_.span(), reach_.span()});
  }

  void search(StepState<V, Exec>& state) {
    Exec& exec = state.exec();
    BroadPhaseParameters<V> parameters = state.parameters();
    const double reach = reduce(exec, "largest reach", reach_.size(), 0.0, ReachAt<Real>{reach_.span()}, Largest{});
    check_period(state.box(), reach);
    parameters.classes = {{static_cast<Real>(reach), reach_.size()}};
    detector_.plan(state.choice().method, parameters, 0);
    BodiesView<V> swept = state.bodies();
    swept.position = middle_.span();
    swept.radius = {reach_.span().data(), 1};
    detector_.find(exec, swept);
  }

  /// A pair must meet across one border of a periodic domain only.
  static void check_period(const Box<V>& box, double reach) {
    for (int axis = 0; box.is_periodic() && axis < kDimensions<V>; ++axis) {
      const double period = double(box.max[axis]) - double(box.min[axis]);
      if (4 * reach <= period) continue;
      std::ostringstream message;
      message << "--swept: a sphere and its way in a step reach over " << 2 * reach
              << " m, allowed in a periodic domain of " << period << " m is half of that; a smaller --dt helps";
      throw RunError(message.str());
    }
  }

  void keep_impacts(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box) {
    const Span<const Pair> candidates = detector_.pairs();
    is_hit_.resize(candidates.size());
    place_.resize(candidates.size() + 1);
    exec.parallel_for("find impacts", candidates.size(),
                      MarkImpact<V>{finder(bodies, box), candidates, is_hit_.span()});
    pairs_.resize(exec.exclusive_scan("scan impacts", is_hit_.span(), place_.span()));
    exec.parallel_for("keep impacts", candidates.size(), KeepMarked{candidates, place_.span(), pairs_.span()});
    first_.resize(bodies.size() + 1);
    exec.parallel_for("keep impacts", first_.size(), KeepRows{detector_.first(), place_.span(), first_.span()});
  }

  Detector<V, Exec> detector_;
  ContactList<V, Exec> list_;
  Buffer<V> way_, middle_;
  Buffer<Real> reach_, time_;
  Buffer<int> is_hit_, place_, first_;
  Buffer<Pair> pairs_;
};

}  // namespace ballpit
