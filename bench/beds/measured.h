// SPDX-License-Identifier: MIT
// What one run of a bed yields, ours or theirs.
#pragma once

#include <cstdint>

namespace ballpit {

/// Steps of one run: the first ones are not timed, so that lists are built and memory is warm.
struct Stretch {
  int64_t warmup = 50;
  int64_t steps = 500;
};

enum class BedClock {
  wall,
  cpu,  ///< time of the process: for a machine that others use as well
};

struct Measured {
  double seconds = 0;         ///< [s] of the wall, the timed steps alone
  double cpu_seconds = 0;     ///< [s] of the process, in the same steps
  double kinetic_energy = 0;  ///< [J] at the end
  int64_t contacts = 0;       ///< at the end, of spheres with each other
  int64_t searches = 0;       ///< for neighbours; ours in all steps, LAMMPS' in the timed ones
};

}  // namespace ballpit
