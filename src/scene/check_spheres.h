// SPDX-License-Identifier: MIT
// Checks spheres that were written down, not generated: inside the domain, and clear of each other.
// Cost: O(n log n) for the sort by size; the search itself is O(n) (sphere_index.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/input_error.h"
#include "scene/scene.h"
#include "scene/sphere_index.h"

namespace ballpit {

/// Where spheres were written: in [[spheres]] tables, or in rows of a CSV file.
struct SphereLines {
  std::string file;
  std::vector<int> line;  ///< one per sphere
  bool csv = false;
};

/// The initial_overlap that allows every overlap.
inline constexpr double kAnyOverlap = 1.0;

/// Makes `bodies` fit `domain`: no third dimension in planar scenes; in periodic ones a centre outside moves to its
/// image inside. Throws UserError for the first sphere that sticks out of walls by more than
/// physics.initial_overlap · radius; and for a pair that overlaps by more than that fraction of the smaller radius,
/// unless it is kAnyOverlap. What rounding to single precision makes is allowed in both. Adds all to `index`. Returns how many
/// spheres were outside of a periodic domain.
int64_t check_spheres(const Domain& domain, const Physics& physics, const SphereLines& lines, Bodies& bodies,
                      SphereIndex& index);

/// Throws UserError unless each edge of a periodic domain is at least four times the largest radius: then two
/// spheres meet across one edge only. `place` is where the domain was written.
void check_periodic_edges(const Domain& domain, double largest_radius, const Place& place);

}  // namespace ballpit
