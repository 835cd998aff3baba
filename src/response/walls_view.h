// SPDX-License-Identifier: MIT
// The walls for a response: those that bodies touch now, or those along the paths of a swept step.
#pragma once

#include "bodies/box.h"
#include "core/span.h"

namespace ballpit {

/// The motion of the bodies in a step with swept contacts; empty if contacts are not swept.
template <class V>
struct Sweep {
  using Real = Scalar<V>;
  Span<const V> way;       ///< [m] of each body, if there were no contacts
  Span<const V> kick;      ///< [m/s] change of velocity by gravity in the step; empty without gravity
  Span<const Real> first;  ///< time of each body's first contact, as a fraction of the step; 1: none
  Span<const Real> time;   ///< the same for each contact

  HOST_DEVICE V kick_of(int i) const { return kick.empty() ? V{} : kick[i]; }
};

/// The walls for a response, at the bodies' positions or along the way of the coming step.
template <class V>
struct WallsView {
  using Real = Scalar<V>;
  Box<V> box;
  Sweep<V> sweep;

  HOST_DEVICE bool is_swept() const { return !sweep.way.empty(); }

  /// Like Box::for_each_wall(), for body i at p. A wall on the way has no overlap yet.
  template <class Visit>
  HOST_DEVICE void for_each(int i, const V& p, Real radius, Visit&& visit) const {
    if (!is_swept()) {
      box.for_each_wall(p, radius, visit);
      return;
    }
    box.for_each_wall_on_way(p, p + sweep.way[i], radius, visit);
  }
};

/// What the walls at min (low) and max (high) have given to each body along each axis: impulses [kg·m/s], or
/// multipliers [kg·m]. Undefined for bodies without a wall; empty if the domain has no walls.
template <class V>
struct WallSums {
  Span<V> low, high;
  HOST_DEVICE Scalar<V>& at(int i, int axis, int side) const { return side < 0 ? low[i][axis] : high[i][axis]; }
};

}  // namespace ballpit
