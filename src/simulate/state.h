// SPDX-License-Identifier: MIT
// The state that the stages of a step share, as views that kernels hold. Stages meet here and nowhere else:
//
//     position, velocity ──broad phase──▶ candidates ──narrow phase──▶ contacts ──response──▶ velocity ──▶ position
//       (frozen)                                        (frozen)
//
// V is Vec2 in planar scenes and Vec3 otherwise. Units: metre, second, kilogram.
#pragma once

#include <cmath>

#include "core/host_device.h"
#include "core/math.h"
#include "core/span.h"
#include "scene/scene.h"
#include "simulate/pair.h"

namespace ballpit {

template <class V>
struct BodiesView {
  Span<const V> position;           ///< [m]
  Span<const V> velocity;           ///< [m/s]
  PerBody<Scalar<V>> radius;        ///< [m]
  PerBody<Scalar<V>> inverse_mass;  ///< [1/kg]

  HOST_DEVICE int64_t size() const { return position.size(); }
};

/// The domain, with the rules at its border.
template <class V>
struct Box {
  using Real = Scalar<V>;
  V min{};
  V max{};
  Boundary boundary = Boundary::walls;

  static constexpr Real kFar = Real(1e30);  ///< [m] above an open top

  HOST_DEVICE bool is_periodic() const { return boundary == Boundary::periodic; }

  /// From a to b; in a periodic domain to b's nearest image. displacement(a, b) = −displacement(b, a) to the bit.
  HOST_DEVICE V displacement(const V& a, const V& b) const {
    V d = b - a;
    if (is_periodic()) {
      for (int axis = 0; axis < kDimensions<V>; ++axis) {
        const Real period = max[axis] - min[axis];
        d[axis] -= period * std::rint(d[axis] / period);
      }
    }
    return d;
  }

  /// The image of p inside a periodic domain, in [min, max) also where rounding is coarse; p itself in others. What is
  /// not finite becomes NaN.
  HOST_DEVICE V wrap(V p) const {
    if (is_periodic()) {
      for (int axis = 0; axis < kDimensions<V>; ++axis) {
        const Real low = min[axis], high = max[axis];
        Real x = p[axis];
        if (x < low || x >= high) {
          x -= (high - low) * std::floor((x - low) / (high - low));
          if (x < low || x >= high) x = low;  // rounded to the edge, or so far out that no digit is left
        }
        p[axis] = x;
      }
    }
    return p;
  }

  /// Whether p is a place where a centre may be: finite, and inside all walls; of a periodic domain, inside after
  /// wrap(). False for NaN.
  HOST_DEVICE bool holds(const V& p) const {
    bool is_held = true;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const Real high = boundary == Boundary::open_top && axis == 1 ? kFar : max[axis];
      is_held = is_held & (p[axis] >= min[axis]) & (p[axis] <= high);
    }
    return is_held;
  }

  /// Calls visit(axis, side, overlap) for each wall that a sphere touches: side −1 at min, +1 at max (the wall lies in
  /// that direction from the sphere), overlap ≥ 0 [m].
  template <class Visit>
  HOST_DEVICE void for_each_wall(const V& p, Real radius, Visit&& visit) const {
    if (is_periodic()) return;
    bool is_near = false;  // one branch that is seldom taken, for six
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      is_near = is_near | (p[axis] - min[axis] <= radius) | (max[axis] - p[axis] <= radius);
    }
    if (!is_near) return;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const Real low = radius - (p[axis] - min[axis]), high = radius - (max[axis] - p[axis]);
      if (low >= 0) visit(axis, -1, low);
      if (high >= 0 && !(axis == 1 && boundary == Boundary::open_top)) visit(axis, 1, high);
    }
  }

  /// The same for each wall that a sphere touches at p, or enters on its way from p to `end`: then without an overlap.
  template <class Visit>
  HOST_DEVICE void for_each_wall_on_way(const V& p, const V& end, Real radius, Visit&& visit) const {
    if (is_periodic()) return;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const Real low = radius - (p[axis] - min[axis]), high = radius - (max[axis] - p[axis]);
      const Real low_end = radius - (end[axis] - min[axis]), high_end = radius - (max[axis] - end[axis]);
      if (low >= 0 || low_end >= 0) visit(axis, -1, low > 0 ? low : Real(0));
      if ((high >= 0 || high_end >= 0) && !(axis == 1 && boundary == Boundary::open_top)) {
        visit(axis, 1, high > 0 ? high : Real(0));
      }
    }
  }
};

/// How bodies move in a step whose contacts are swept; empty where they are not.
template <class V>
struct Sweep {
  using Real = Scalar<V>;
  Span<const V> way;       ///< [m] of each body, if it met nothing
  Span<const V> kick;      ///< [m/s] what gravity adds to its velocity in the step; empty without gravity
  Span<const Real> first;  ///< when it meets its first contact, as a fraction of the step; 1: it does not
  Span<const Real> time;   ///< the same for each contact

  HOST_DEVICE V kick_of(int i) const { return kick.empty() ? V{} : kick[i]; }
};

/// The walls as a response meets them: where bodies are, or along the way that they are about to go.
template <class V>
struct WallsView {
  using Real = Scalar<V>;
  Box<V> box;
  Sweep<V> sweep;

  HOST_DEVICE bool is_swept() const { return !sweep.way.empty(); }

  /// As Box::for_each_wall(), for body i at p; a wall that is met on the way has no overlap yet.
  template <class Visit>
  HOST_DEVICE void for_each(int i, const V& p, Real radius, Visit&& visit) const {
    if (!is_swept()) {
      box.for_each_wall(p, radius, visit);
      return;
    }
    box.for_each_wall_on_way(p, p + sweep.way[i], radius, visit);
  }
};

/// Where a response notes what it does, for a tally; empty spans where none is kept.
template <class V>
struct ImpulseNotes {
  Span<Scalar<V>> contact;  ///< [kg·m/s] exchanged by each contact
  Span<Scalar<V>> floor;    ///< [kg·m/s] given by each body to the wall at min.y

  HOST_DEVICE bool are_kept() const { return !floor.empty(); }
};

/// Kernel: to = from.
template <class T>
struct CopyValues {
  Span<const T> from;
  Span<T> to;
  HOST_DEVICE void operator()(int i) const { to[i] = from[i]; }
};

/// Spheres that touch exactly are in contact: |d|² ≤ (r_i + r_j)².
template <class V>
HOST_DEVICE bool in_contact(const V& d, Scalar<V> radii) {
  return dot(d, d) <= radii * radii;
}

/// What the narrow phase measures of a contact (i, j).
template <class V>
struct ContactGeometry {
  V normal;              ///< unit vector from i to j
  Scalar<V> overlap;     ///< r_i + r_j − |x_j − x_i| ≥ 0 [m]
  Scalar<V> separation;  ///< speed at which the spheres part along the normal; negative while they approach [m/s]
};

/// A contact as its second body lists it.
struct IncomingContact {
  int contact;
  int body;  ///< the first body of that contact: held here, since looking it up would be one more jump in memory
};

/// Contacts in canonical order (by i, then j), and for each body the contacts that it is part of:
/// those with i = body are [first[body], first[body + 1]); those with j = body are listed in
/// incoming[incoming_first[body]] … incoming[incoming_first[body + 1] − 1], ascending.
template <class V>
struct ContactsView {
  Span<const Pair> pairs;
  Span<const ContactGeometry<V>> geometry;
  Span<const int> first;
  Span<const int> incoming_first;
  Span<const IncomingContact> incoming;

  HOST_DEVICE int count_of(int body) const {
    return first[body + 1] - first[body] + incoming_first[body + 1] - incoming_first[body];
  }

  /// Calls visit(contact, other body, side) in the order of contacts; side is +1 where the normal points away from `body`,
  /// −1 where it points to it.
  template <class Visit>
  HOST_DEVICE void for_each_of(int body, Visit&& visit) const {
    for (int k = incoming_first[body]; k < incoming_first[body + 1]; ++k) {
      visit(incoming[k].contact, incoming[k].body, -1);
    }
    for (int c = first[body]; c < first[body + 1]; ++c) visit(c, pairs[c].j, 1);
  }
};

}  // namespace ballpit
