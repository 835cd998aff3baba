// SPDX-License-Identifier: MIT
// Spheres in CSV files: a header names the columns x, y, z, radius and optionally vx, vy, vz, mass, in any
// order; then one sphere a line. Numbers are the shortest that read back as the same double, so a round trip
// is exact. Cost: O(bytes), one pass; a million spheres of eight columns read in well under a second.
#pragma once

#include <filesystem>
#include <string_view>

#include "scene/scene.h"

namespace ballpit {

/// Reads the spheres in `path`. Velocities that the file lacks are 0, masses are `density` [kg/m³] · volume.
/// Sphere i stands in line i + 2. Throws UserError naming file, line and column, what was found and what is
/// allowed.
Bodies read_spheres_csv(const std::filesystem::path& path, double density = 1000.0);

/// The same from text; `file_name` is what errors call it.
Bodies parse_spheres_csv(std::string_view text, std::string_view file_name, double density = 1000.0);

/// Writes all eight columns. Throws RunError if the file cannot be written.
void write_spheres_csv(const std::filesystem::path& path, const Bodies& bodies);

}  // namespace ballpit
