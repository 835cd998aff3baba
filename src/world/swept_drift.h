// SPDX-License-Identifier: MIT
// The drift of a swept step (swept.h).
#pragma once

#include <cmath>
#include <limits>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/contacts.h"
#include "bodies/tally.h"
#include "response/walls_view.h"
#include "world/between_walls.h"

namespace ballpit {

/// Kernel: position and velocity of body i after the step. It moves on its parabola up to its first contact, then with the
/// velocity from the response, but not through a wall. A body that meets only walls bounces exactly.
template <class V>
struct SweptDrift {
  using Real = Scalar<V>;
  BodiesView<V> bodies;  ///< before the step
  Box<V> box;
  ContactsView<V> contacts;
  Sweep<V> sweep;
  Span<const V> responded;   ///< velocities by the response
  Span<const V> correction;  ///< [m]
  Span<const V> kicked;      ///< velocities after the kick
  V change;                  ///< g·dt [m/s]
  Real dt, wall_restitution;
  Span<V> position, velocity;
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int i) const {
    if (!box.is_periodic() && contacts.count_of(i) == 0 && is_inside(i)) {
      bounce(i);
      return;
    }
    const V p = bodies.position[i], kick = sweep.kick_of(i), after = responded[i];
    const Real before = sweep.first[i], rest = 1 - before;
    V end = p + sweep.way[i] * before + after * (rest * dt) + correction[i];
    if (!sweep.kick.empty()) {
      end -= kick * (before * rest * dt / 2);  // from the chord to the parabola
      if (is_flying(i)) end -= kick * (rest * rest * dt / 2);
    }
    if (!box.is_periodic()) keep_inside(p, bodies.radius[i], end);
    position[i] = end;
    velocity[i] = after;
    if (notes.are_kept() && !box.is_periodic() && change[1] < 0) {  // a body on the floor was not kicked
      notes.floor[i] += (kicked[i] - bodies.velocity[i] - change)[1] / bodies.inverse_mass[i];
    }
  }

 private:
  static constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();  // not called on a device

  /// Whether body i is between the walls, up to rounding.
  HOST_DEVICE bool is_inside(int i) const {
    bool is_held = true;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const Real p = bodies.position[i][axis], low = low_of(i, axis), high = high_of(i, axis);
      const Real rounded = 8 * kEpsilon * (std::fabs(box.min[axis]) + bodies.radius[i]);
      is_held = is_held & (low <= high) & (p >= low - rounded) & (p <= high + rounded);
    }
    return is_held;
  }

  HOST_DEVICE Real low_of(int i, int axis) const { return box.min[axis] + bodies.radius[i]; }
  HOST_DEVICE Real high_of(int i, int axis) const {
    return axis == 1 && box.boundary == Boundary::open_top ? box.kFar : box.max[axis] - bodies.radius[i];
  }

  HOST_DEVICE void bounce(int i) const {
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      Real p = bodies.position[i][axis], v = bodies.velocity[i][axis];
      const BetweenWalls<Real> walls{low_of(i, axis), high_of(i, axis), change[axis] / dt, wall_restitution};
      const Real given = walls.fly(p, v, dt);
      if (notes.are_kept() && axis == 1) notes.floor[i] = given / bodies.inverse_mass[i];
      position[i][axis] = p;
      velocity[i][axis] = v;
    }
  }

  /// Whether body i separates from everything that it meets. If not, it is held, and does not fall in the rest of the step.
  HOST_DEVICE bool is_flying(int i) const {
    const V own = responded[i];
    const Real least = Real(0.01) * std::sqrt(dot(change, change));
    bool is_free = true;
    contacts.for_each_of(i, [&](int c, int other, int side) {
      is_free = is_free & (dot(responded[other] - own, contacts.geometry[c].normal) * Real(side) > least);
    });
    const V p = bodies.position[i];
    box.for_each_wall_on_way(p, p + sweep.way[i], bodies.radius[i],
                             [&](int axis, int side, Real) { is_free = is_free & (-Real(side) * own[axis] > least); });
    return is_free;
  }

  /// A sphere that did not overlap a wall must not overlap it at the end of its path.
  HOST_DEVICE void keep_inside(const V& p, Real radius, V& end) const {
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const Real low = box.min[axis] + radius, high = box.max[axis] - radius;
      const Real least = p[axis] < low ? p[axis] : low, most = p[axis] > high ? p[axis] : high;
      if (end[axis] < least) end[axis] = least;
      if (end[axis] > most && !(axis == 1 && box.boundary == Boundary::open_top)) end[axis] = most;
    }
  }
};

}  // namespace ballpit
