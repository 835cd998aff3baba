// SPDX-License-Identifier: MIT
// Sums over all collisions of a run.
#pragma once

#include <cstdint>

namespace ballpit {

/// Sums over all collisions since the start, from which observables.h computes figures. Only worlds whose settings ask
/// for it keep a tally.
struct Tally {
  int64_t collisions = 0;    ///< between spheres, each counted once
  double virial = 0;         ///< [J·s] Σ over collisions of Δp·d: the impulse times the distance of the centres
  double floor_impulse = 0;  ///< [kg·m/s] of spheres on the wall at min.y
};

}  // namespace ballpit
