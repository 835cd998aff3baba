// SPDX-License-Identifier: MIT
// Two beds of equal spheres in a box with an open top, under gravity. bench_beds steps them with the penalty response
// and with LAMMPS. Positions, velocities, radius and walls are exact in single precision, so both programs start from
// the same numbers. Cost: that of the steps which bring them from a lattice into their state.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

struct BedInfo {
  std::string_view name;
  std::string_view description;
};

/// loose, dense.
std::span<const BedInfo> beds();

struct Bed {
  std::string name;
  Scene scene;  ///< start, box and physics
  double dt;    ///< [s] about a fiftieth of a contact's duration
};

/// The dense bed falls and comes to rest in `settle_steps` steps of the penalty response, and is then shaken; the loose
/// one moves for a quarter of these steps. Throws UserError for an unknown name.
Bed make_bed(std::string_view name, int64_t count, uint64_t seed, int64_t settle_steps);

/// The settings for a bed: penalty response, one thread of the CPU, automatic broad phase.
Settings bed_settings(double dt);

}  // namespace ballpit
