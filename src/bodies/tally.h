// SPDX-License-Identifier: MIT
// Sums over all collisions of a run, and the arrays in which a response notes impulses for them.
#pragma once

#include "core/math.h"
#include "core/span.h"

namespace ballpit {

/// Sums over all collisions since the start, from which observables.h computes figures. Only worlds whose settings ask
/// for it keep a tally.
struct Tally {
  int64_t collisions = 0;    ///< between spheres, each counted once
  double virial = 0;         ///< [J·s] Σ over collisions of Δp·d: the impulse times the distance of the centres
  double floor_impulse = 0;  ///< [kg·m/s] of spheres on the wall at min.y
  int64_t wall_hits = 0;     ///< of spheres and walls; a sphere that lies on a wall does not hit it again

  Tally operator+(const Tally& o) const {
    return {collisions + o.collisions, virial + o.virial, floor_impulse + o.floor_impulse, wall_hits + o.wall_hits};
  }
};

/// The impulses that a response applies, and hits of walls, noted for a tally; empty spans if no tally is kept.
template <class V>
struct ImpulseNotes {
  Span<Scalar<V>> contact;  ///< [kg·m/s] of each contact
  Span<Scalar<V>> floor;    ///< [kg·m/s] of each body on the wall at min.y
  Span<int64_t> wall_hits;  ///< of each body, where contacts are swept; elsewhere its positions show them

  HOST_DEVICE bool are_kept() const { return !floor.empty(); }
};

}  // namespace ballpit
