// SPDX-License-Identifier: MIT
// Spheres in CSV files: a header names the columns x, y, z, radius and optionally vx, vy, vz, mass, in any
// order; then one sphere a line. Numbers are the shortest that read back as the same double, so a round trip
// is exact. Cost: O(bytes), one pass through a buffer of a megabyte; the spheres are all that is kept.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace ballpit {

/// Reads the spheres in `path`. Velocities that the file lacks are 0, masses are `density` [kg/m³] · volume.
/// Sphere i stands in line i + 2. Throws UserError naming file, line and column, what was found and what is
/// allowed.
Bodies read_spheres_csv(const std::filesystem::path& path, double density = 1000.0);

/// The same from text; `file_name` is what errors call it.
Bodies parse_spheres_csv(std::string_view text, std::string_view file_name, double density = 1000.0);

/// Spheres at rest, as a search for pairs takes them: 16 bytes each.
struct RestingSpheres {
  std::vector<Vec3> position;  ///< [m] rounded from the file's doubles
  std::vector<float> radius;   ///< [m] the same

  int64_t size() const { return static_cast<int64_t>(position.size()); }
};

/// Reads centres and radii alone. Other columns are checked as read_spheres_csv() does, and left out; masses that the
/// file lacks are not made, so radii have no limit but their own.
RestingSpheres read_resting_spheres(const std::filesystem::path& path);

/// The same from text; `file_name` is what errors call it.
RestingSpheres parse_resting_spheres(std::string_view text, std::string_view file_name);

/// Writes all eight columns. Throws RunError if the file cannot be written.
void write_spheres_csv(const std::filesystem::path& path, const Bodies& bodies);

}  // namespace ballpit
