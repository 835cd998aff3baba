// SPDX-License-Identifier: MIT
// Spheres in CSV files: a header names the columns x, y, z, radius and optionally vx, vy, vz, mass, in any
// order; then one sphere a line. What else programs write is read too (csv_header.h): diameters, other separators,
// decimal commas where the separator is no comma, quotes, blank lines, and comments behind '#'. Written are commas and
// decimal points; numbers are the shortest that read back as the same double, so a round trip is exact. What is too
// small for a double is read as 0.
// Cost: O(bytes), one pass through a buffer of a megabyte; the spheres are all that is kept.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace ballpit {

/// Where the spheres of a file stand, and what the user is to know about it.
struct SphereSource {
  std::vector<int> line;  ///< of each sphere
  std::string note;       ///< names the columns that are ignored; empty where none is
};

/// Reads the spheres in `path`. Velocities that the file lacks are 0, masses are `density` [kg/m³] · volume.
/// Throws UserError naming file, line and column, what was found and what is allowed.
Bodies read_spheres_csv(const std::filesystem::path& path, double density = 1000.0, SphereSource* source = nullptr);

/// The same from text; `file_name` is what errors call it.
Bodies parse_spheres_csv(std::string_view text, std::string_view file_name, double density = 1000.0,
                         SphereSource* source = nullptr);

/// Spheres at rest, as a search for pairs takes them: 16 bytes each.
struct RestingSpheres {
  std::vector<Vec3> position;  ///< [m] rounded from the file's doubles
  std::vector<float> radius;   ///< [m] the same
  std::string note{};          ///< for the user: what was ignored of their file; empty where nothing was

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
