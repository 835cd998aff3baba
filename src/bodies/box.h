// SPDX-License-Identifier: MIT
// The domain for kernels: displacements, wrapping and walls.
#pragma once

#include <cmath>

#include "core/host_device.h"
#include "scene/scene.h"

namespace ballpit {

/// The domain and the rules at its border.
template <class V>
struct Box {
  using Real = Scalar<V>;
  V min{};
  V max{};
  Boundary boundary = Boundary::walls;

  static constexpr Real kFar = Real(1e30);  ///< [m] upper limit of positions under an open top

  HOST_DEVICE bool is_periodic() const { return boundary == Boundary::periodic; }

  /// Its length along an axis [m].
  HOST_DEVICE double extent(int axis) const { return double(max[axis]) - double(min[axis]); }

  /// From a to b; in a periodic domain to b's nearest image. displacement(a, b) and −displacement(b, a) are
  /// bit-identical.
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

  /// The image of p inside a periodic domain, always in [min, max) despite rounding; in other domains p itself.
  /// Infinite coordinates become NaN.
  HOST_DEVICE V wrap(V p) const {
    if (is_periodic()) {
      for (int axis = 0; axis < kDimensions<V>; ++axis) {
        const Real low = min[axis], high = max[axis];
        Real x = p[axis];
        if (x < low || x >= high) {
          x -= (high - low) * std::floor((x - low) / (high - low));
          if (x < low || x >= high) x = low;  // rounded to the edge, or so far out that no digit is significant
        }
        p[axis] = x;
      }
    }
    return p;
  }

  /// Whether p is a valid position of a centre: finite and inside all walls (in a periodic domain, call wrap() first).
  /// False for NaN.
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
    bool is_near = false;  // one branch, seldom taken, instead of six
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      is_near = is_near | (p[axis] - min[axis] <= radius) | (max[axis] - p[axis] <= radius);
    }
    if (is_near) for_each_wall_on_way(p, p, radius, visit);
  }

  /// The same for each wall that a sphere touches at p, or enters on its way from p to `end`, then with overlap 0.
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

/// Whether two spheres are in contact; those that touch exactly are: |d|² ≤ (r_i + r_j)².
template <class V>
HOST_DEVICE bool in_contact(const V& d, Scalar<V> radii) {
  return dot(d, d) <= radii * radii;
}

}  // namespace ballpit
