// SPDX-License-Identifier: MIT
// The walls as a response sees them, at rest or along the paths of a swept step.
#pragma once

#include "bodies/box.h"
#include "core/span.h"

namespace ballpit {

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

}  // namespace ballpit
