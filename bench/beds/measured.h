// SPDX-License-Identifier: MIT
// The result of one run of a bed, with either program.
#pragma once

#include <cstdint>

namespace ballpit {

/// The steps of one run. The first are not timed: they build lists and warm up memory.
struct Stretch {
  int64_t warmup = 50;
  int64_t steps = 500;
};

enum class BedClock {
  wall,
  cpu,  ///< time of the process: for a busy machine
};

struct Measured {
  double seconds = 0;         ///< [s] of the wall, the timed steps alone
  double cpu_seconds = 0;     ///< [s] of the process, in the same steps
  double kinetic_energy = 0;  ///< [J] at the end
  int64_t contacts = 0;       ///< at the end, of spheres with each other
  int64_t searches = 0;       ///< for neighbours; ours in all steps, LAMMPS' in the timed ones
};

}  // namespace ballpit
