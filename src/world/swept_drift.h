// SPDX-License-Identifier: MIT
// The drift of a swept step (swept.h). Bodies that meet only walls bounce exactly, any number of times:
//
//     low ├──▸────────────┤ high     p(t) = p + v·t + a·t²/2;  at a wall v ← −e·v, with the v at that moment
//
// Walls are at right angles and there is no friction, so coordinates are independent. A sphere that leaves a wall at
// speed w against an acceleration a returns after 2w/a, and comes to rest after 2w/(a·(1 − e)).
// Cost: O(bounces). Source: docs/responses.md, "Swept contacts".
#pragma once

#include <cmath>
#include <limits>

#include "bodies/bodies_view.h"
#include "bodies/contacts.h"
#include "bodies/tally.h"
#include "response/walls_view.h"
#include "world/swept_impacts.h"

namespace ballpit {

/// The time [s] until a plane `distance` [m] ahead is reached at `speed` [m/s] and `acceleration` [m/s²]; 1e30 if it is
/// not.
template <class Real>
HOST_DEVICE Real time_to_wall(Real distance, Real speed, Real acceleration) {
  constexpr Real kNever = Real(1e30);
  if (speed <= 0 && acceleration <= 0) return kNever;
  if (distance <= 0 && speed > 0) return 0;
  const Real squared = speed * speed + 2 * acceleration * distance;
  if (speed > 0) return squared < 0 ? kNever : 2 * distance / (speed + std::sqrt(squared));
  return (-speed + std::sqrt(squared > 0 ? squared : Real(0))) / acceleration;
}

/// What a sphere did at the two walls along one axis.
template <class Real>
struct Bounces {
  Real given = 0;  ///< [m/s] speed that the wall at `low` gave it
  Real hits = 0;   ///< of either wall, a whole number (to 2²⁴ in float); those before it rests are one
};

/// The two walls along one axis.
template <class Real>
struct BetweenWalls {
  Real low, high;     ///< [m] positions of the centre in contact with them
  Real acceleration;  ///< [m/s²]
  Real restitution;

  static constexpr int kMaxBounces = 32;  ///< in a step; after that the rest of the step is lost

  /// Advances a sphere by `left` [s].
  HOST_DEVICE Bounces<Real> fly(Real& position, Real& velocity, Real left) const {
    Bounces<Real> sum;
    Real& given = sum.given;
    for (int k = 0; k < kMaxBounces; ++k) {
      const Real to_low = time_to_wall(position - low, -velocity, -acceleration);
      const Real to_high = time_to_wall(high - position, velocity, acceleration);
      const Real side = to_low <= to_high ? Real(-1) : Real(1);
      const Real time = side < 0 ? to_low : to_high;
      if (time >= left) {
        position = inside(position + velocity * left + acceleration * left * left / 2);
        velocity += acceleration * left;
        return sum;
      }
      const Real wall = side < 0 ? low : high, pressing = side * acceleration;
      const Real squared = velocity * velocity + 2 * pressing * (side * (wall - position));
      const Real arriving = std::sqrt(squared > 0 ? squared : Real(0)), parting = restitution * arriving;
      left -= time;
      position = wall;
      velocity = -side * parting;
      if (arriving > 0) sum.hits += 1;  // it does not lie there
      if (side < 0) given += arriving + parting;
      if (!(pressing > 0)) continue;
      const Real period = 2 * parting / pressing;
      if (period <= left * (1 - restitution)) {  // comes to rest within the step
        if (side < 0) given += pressing * left - parting;
        velocity = 0;
        return sum;
      }
      if (restitution == 1 && period < left) {  // identical bounces
        const Real bounces = std::floor(left / period);
        left -= bounces * period;
        sum.hits += bounces;
        if (side < 0) given += bounces * 2 * parting;
      }
    }
    return sum;
  }

  HOST_DEVICE Real inside(Real position) const {
    if (position < low) return low;
    return position > high ? high : position;
  }
};

/// Kernel: position and velocity of body i after the step. It moves on its parabola up to its first contact, then with
/// the velocity from the response, but not through a wall. A body that meets only walls bounces exactly.
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
    if (meets_only_walls(i)) {
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

  /// The hits of walls by body i: all of one that meets only walls; of others, those before they meet anything else. A
  /// later one comes in the next step, if at all.
  HOST_DEVICE int64_t wall_hits_of(int i) const {
    Real hits = 0;
    const V start = bodies.position[i], way = sweep.way[i];
    if (meets_only_walls(i)) {
      for (int axis = 0; axis < kDimensions<V>; ++axis) {
        Real p = start[axis], v = bodies.velocity[i][axis];
        hits += walls_of(i, axis).fly(p, v, dt).hits;
      }
    } else {
      box.for_each_wall_on_way(start, start + way, bodies.radius[i], [&](int axis, int side, Real) {
        const bool is_moving_there = Real(side) * way[axis] > 0;
        hits += is_moving_there && time_of_wall(box, start, way, bodies.radius[i], axis, side) <= sweep.first[i];
      });
    }
    return hits < Real(1e15) ? int64_t(hits) : int64_t(1e15);
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

  HOST_DEVICE bool meets_only_walls(int i) const {
    return !box.is_periodic() && contacts.count_of(i) == 0 && is_inside(i);
  }

  HOST_DEVICE BetweenWalls<Real> walls_of(int i, int axis) const {
    return {low_of(i, axis), high_of(i, axis), change[axis] / dt, wall_restitution};
  }

  HOST_DEVICE void bounce(int i) const {
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      Real p = bodies.position[i][axis], v = bodies.velocity[i][axis];
      const Bounces<Real> bounces = walls_of(i, axis).fly(p, v, dt);
      if (notes.are_kept() && axis == 1) notes.floor[i] = bounces.given / bodies.inverse_mass[i];
      position[i][axis] = p;
      velocity[i][axis] = v;
    }
  }

  /// Whether body i separates from everything that it meets. If not, it is held, and does not fall in the rest of the
  /// step.
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

/// Kernel, for a tally. Apart from the drift, which would take more registers with it.
template <class V>
struct CountWallHits {
  SweptDrift<V> drift;
  Span<int64_t> wall_hits;

  HOST_DEVICE void operator()(int i) const { wall_hits[i] = drift.wall_hits_of(i); }
};

}  // namespace ballpit
