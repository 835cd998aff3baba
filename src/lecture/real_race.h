// SPDX-License-Identifier: MIT
// The race of slide 16 on real threads. What they lose differs from run to run, and may be nothing.
#pragma once

#include <cstdint>

namespace ballpit::lecture {

struct RealRace {
  int threads = 0;   ///< of the CPU
  int64_t lost = 0;  ///< spheres that are in no list afterwards
};

/// Inserts `count` spheres at random places into 3 × 3 cells once, by relaxed loads and stores, on all cores.
RealRace race_on_threads(int64_t count);

}  // namespace ballpit::lecture
