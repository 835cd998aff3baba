// SPDX-License-Identifier: MIT
// Swept contacts: a sphere that would pass another one, or a wall, within a step collides where they meet.
//
//      ╭───────────────╮       the broad phase gets the sphere around each path: its middle, radius r + |path|/2
//      │ ○╌╌╌╌╌╌╌╌╌▸○  │       |d + v·t| = r_i + r_j,  d, v relative:  t = c / (−b + √(b² − a·c)) with
//      ╰───────────────╯       a = v·v, b = d·v, c = d·d − (r_i + r_j)²  (no cancellation)
//
// A pair with t in [0, dt] is a contact, with its normal at time t. Each body moves on its parabola up to its first contact.
// The response gets its velocity at that moment, v + t·g·dt; with the velocity before the kick, a ball would lose g·dt in
// each bounce. Then the body moves on with its new velocity and the rest of the kick (swept_drift.h). So the first hit of a
// body in a step cannot be missed, and no body leaves through a wall. A second hit in the same step is found in the next
// step, if the bodies still overlap then. Bodies that meet only walls bounce exactly (swept_drift.h).
// A body that lies on a wall is not kicked against it; otherwise the speed of what strikes it would be wrong.
// Cost: the broad phase on larger spheres, O(candidates + n). Source: Ericson 2005, section 5.5.5.
#pragma once

#include <limits>

#include "core/error.h"
#include "narrow_phase/collider.h"
#include "response/walls_view.h"
#include "world/body_store.h"
#include "world/sums.h"
#include "world/swept_impacts.h"

namespace ballpit {

/// Kernel: the velocity of body i before and after the kick. Where it lies on a wall, both are 0.
template <class V>
struct KickUnlessHeld {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  Box<V> box;
  V change;  ///< g·dt [m/s]
  Real dt;
  Span<V> start, kick, kicked;

  HOST_DEVICE void operator()(int i) const {
    V own = change, velocity = bodies.velocity[i];
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      if (change[axis] != 0 && is_held(i, axis)) own[axis] = velocity[axis] = 0;
    }
    start[i] = velocity;
    kick[i] = own;
    kicked[i] = velocity + own;
  }

 private:
  static constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();  // not called on a device

  /// A body lies on a wall if a hop would end within the step, or is smaller than rounding.
  HOST_DEVICE bool is_held(int i, int axis) const {
    if (box.is_periodic() || (axis == 1 && change[axis] > 0 && box.boundary == Boundary::open_top)) return false;
    const Real p = bodies.position[i][axis], v = bodies.velocity[i][axis], radius = bodies.radius[i];
    const Real wall = change[axis] < 0 ? box.min[axis] : box.max[axis];
    const Real gap = std::fabs(p - wall) - radius, pressed = std::fabs(change[axis]) * dt;
    const Real rounded = 8 * kEpsilon * (std::fabs(wall) + radius);
    const Real height = (gap > 0 ? gap : Real(0)) + v * v * dt * dt / (2 * pressed);
    return height <= (pressed / 8 > rounded ? pressed / 8 : rounded);
  }
};

/// Kernel: the path of body i, and the sphere around it.
template <class V>
struct SweepBody {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const V> kick;  ///< empty without gravity
  Real dt;
  Span<V> way, middle;
  Span<Real> reach;

  HOST_DEVICE void operator()(int i) const {
    V w = bodies.velocity[i] * dt;
    if (!kick.empty()) w += kick[i] * (dt / 2);
    way[i] = w;
    middle[i] = box.wrap(bodies.position[i] + w / Real(2));
    reach[i] = bodies.radius[i] + std::sqrt(dot(w, w)) / 2 * Real(1.00001);  // rounding must not shorten it
  }
};

template <class V, class Exec>
class SweptContacts {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// The contacts of a step of dt that begins at the present state, found by the broad phase of `collider`.
  ContactsView<V> find(const BodyStore<V, Exec>& store, const Collider<V, Exec>& collider, Real dt) {
    Exec& exec = store.exec();
    const Box<V>& box = store.box();
    kick(exec, store, dt);
    const BodiesView<V> bodies = this->bodies(store);
    cover_ways(exec, bodies, box, dt);
    search(store, collider);
    keep_impacts(exec, bodies, box);
    list_.build(exec, pairs_.span(), first_.span(), bodies, box);
    time_.resize(pairs_.size());
    exec.parallel_for(
        "measure impacts", pairs_.size(),
        MeasureImpact<V>{finder(bodies, box), kick_.span(), pairs_.span(), list_.geometry(), time_.span()});
    met_.resize(bodies.size());
    exec.parallel_for("find first impacts", bodies.size(),
                      FindFirst<V>{bodies, box, list_.view(), way_.span(), time_.span(), met_.span()});
    return list_.view();
  }

  /// The bodies with their velocities at the start of the step; a body that lies on a wall has none against it. After find().
  BodiesView<V> bodies(const BodyStore<V, Exec>& store) const {
    BodiesView<V> bodies = store.view();
    if (kick_.size() > 0) bodies.velocity = start_.span();
    return bodies;
  }

  /// How bodies move, and when contacts occur; after find().
  Sweep<V> sweep() const { return {way_.span(), kick_.span(), met_.span(), time_.span()}; }

  /// Velocities after the kick; after find().
  Span<const V> kicked(const BodyStore<V, Exec>& store) const {
    return kick_.size() > 0 ? kicked_.span() : store.view().velocity;
  }

  int64_t bytes() const {
    return way_.bytes() + middle_.bytes() + start_.bytes() + kick_.bytes() + kicked_.bytes() + reach_.bytes() +
           met_.bytes() + is_hit_.bytes() + place_.bytes() + first_.bytes() + pairs_.bytes() + time_.bytes() +
           collider_.bytes();
  }

 private:
  FindImpact<V> finder(const BodiesView<V>& bodies, const Box<V>& box) const {
    return {bodies, box, way_.span(), middle_.span()};
  }

  void kick(Exec& exec, const BodyStore<V, Exec>& store, Real dt) {
    if (!store.has_gravity()) return;
    const int64_t n = store.count();
    for (Buffer<V>* buffer : {&start_, &kick_, &kicked_}) buffer->resize(n);
    exec.parallel_for("kick", n,
                      KickUnlessHeld<V>{store.view(), store.box(), store.gravity() * dt, dt, start_.span(),
                                        kick_.span(), kicked_.span()});
  }

  void cover_ways(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, Real dt) {
    const int64_t n = bodies.size();
    way_.resize(n);
    middle_.resize(n);
    reach_.resize(n);
    exec.parallel_for("sweep bodies", n,
                      SweepBody<V>{bodies, box, kick_.span(), dt, way_.span(), middle_.span(), reach_.span()});
  }

  void search(const BodyStore<V, Exec>& store, const Collider<V, Exec>& collider) {
    Exec& exec = store.exec();
    BroadPhaseParameters<V> parameters = collider.parameters();
    const double reach = reduce(exec, "largest reach", reach_.size(), 0.0, DoubleAt<Real>{reach_.span()}, Largest{});
    check_period(store.box(), reach);
    parameters.classes = {{static_cast<Real>(reach), reach_.size()}};
    collider_.plan(collider.choice(), parameters, 0);
    BodiesView<V> swept = store.view();
    swept.position = middle_.span();
    swept.radius = {reach_.span().data(), 1};
    candidates_ = collider_.pairs(exec, swept);
  }

  /// A pair may only meet across one border of a periodic domain.
  static void check_period(const Box<V>& box, double reach) {
    for (int axis = 0; box.is_periodic() && axis < kDimensions<V>; ++axis) {
      const double period = double(box.max[axis]) - double(box.min[axis]);
      if (4 * reach <= period) continue;
      throw RunError("--swept",
                     streamed("a sphere and its way in a step reach over ", 2 * reach,
                              " m, allowed in a periodic domain of ", period, " m is half of that"),
                     "a smaller --dt helps");
    }
  }

  void keep_impacts(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box) {
    const Span<const Pair> candidates = candidates_;
    is_hit_.resize(candidates.size());
    place_.resize(candidates.size() + 1);
    exec.parallel_for("find impacts", candidates.size(),
                      MarkImpact<V>{finder(bodies, box), candidates, is_hit_.span()});
    pairs_.resize(exec.exclusive_scan("scan impacts", is_hit_.span(), place_.span()));
    exec.parallel_for("keep impacts", candidates.size(), KeepMarked{candidates, place_.span(), pairs_.span()});
    first_.resize(bodies.size() + 1);
    exec.parallel_for("keep impacts", first_.size(), KeepRows{collider_.rows().first(), place_.span(), first_.span()});
  }

  Collider<V, Exec> collider_;  // for the spheres around the paths
  Span<const Pair> candidates_;
  ContactList<V, Exec> list_;
  Buffer<V> way_, middle_, start_, kick_, kicked_;
  Buffer<Real> reach_, time_;
  Buffer<Real> met_;  // when each body meets its first contact
  Buffer<int> is_hit_, place_, first_;
  Buffer<Pair> pairs_;
};

}  // namespace ballpit
