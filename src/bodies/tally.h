// SPDX-License-Identifier: MIT
// What collisions did in a run.
#pragma once

#include <cstdint>

namespace ballpit {

/// What collisions did since the start; observables.h makes figures of it. Kept by worlds whose settings ask for it.
struct Tally {
  int64_t collisions = 0;    ///< of spheres with each other, each counted once
  double virial = 0;         ///< [J·s] Σ over collisions of Δp·d: the impulse times the distance of the centres
  double floor_impulse = 0;  ///< [kg·m/s] that spheres gave the wall at min.y
};

}  // namespace ballpit
