// SPDX-License-Identifier: MIT
// Checks the spheres of a file: they must be inside the domain and must not overlap.
// Cost: O(n log n) for the sort by size; the search itself is O(n) (sphere_index.h).
#pragma once

#include "scene/input_error.h"
#include "scene/sphere_index.h"

namespace ballpit {

/// The lines of spheres in a file: [[spheres]] tables, or rows of a CSV file.
struct SphereLines {
  std::string file;
  std::vector<int> line;  ///< one per sphere
  bool csv = false;
};

/// The value of initial_overlap that allows every overlap.
inline constexpr double kAnyOverlap = 1.0;

/// Makes `bodies` fit `domain`: removes the third dimension in planar scenes, and moves centres outside of a periodic domain to
/// their images inside. Throws UserError for the first sphere that overlaps a wall by more than physics.initial_overlap ·
/// radius, and for a pair that overlaps by more than that fraction of the smaller radius, unless it is kAnyOverlap. Overlaps
/// from rounding to single precision are allowed. Adds all spheres to `index`. Returns how many were outside of a periodic
/// domain.
int64_t check_spheres(const Domain& domain, const Physics& physics, const SphereLines& lines, Bodies& bodies,
                      SphereIndex& index);

/// Throws UserError unless each edge of a periodic domain is at least four times the largest radius, so that two spheres touch
/// across one edge only. `place` is the domain's in the file.
void check_periodic_edges(const Domain& domain, double largest_radius, const Place& place);

}  // namespace ballpit
