// SPDX-License-Identifier: MIT
// Spheres in CSV files: a header names the columns x, y, z, radius and optionally vx, vy, vz, mass, in any order; then one
// sphere per line. Formats of other programs are read too (csv_header.h): diameters, other separators, decimal commas if the
// separator is not a comma, quotes, blank lines, and comments after '#'. Files are written with commas and decimal points;
// numbers are the shortest that read back as the same double, so a round trip is exact. Numbers too small for a double are
// read as 0.
// Cost: O(bytes), one pass through a buffer of a megabyte.
#pragma once

#include "scene/line_reader.h"
#include "scene/scene.h"

namespace ballpit {

/// The lines of the spheres in a file: [[spheres]] tables, or rows of a CSV file.
struct SphereLines {
  std::string file;
  std::vector<int> line;  ///< of each sphere
  bool csv = false;
  std::string note{};  ///< for the user: the columns that are ignored; empty if there are none
};

/// Reads the spheres in `lines`; a path converts to them. Missing velocities are 0, missing masses `density` [kg/m³] · volume.
/// Throws UserError naming file, line and column, what was found and what is allowed.
Bodies read_spheres_csv(LineReader lines, double density = 1000.0, SphereLines* source = nullptr);

/// Spheres at rest for a search for pairs: 16 bytes each.
struct RestingSpheres {
  std::vector<Vec3> position;  ///< [m] rounded from the file's doubles
  std::vector<float> radius;   ///< [m] the same
  std::string note{};          ///< names the columns that are ignored; empty if there are none

  int64_t size() const { return static_cast<int64_t>(position.size()); }
};

/// Reads only centres and radii. Other columns are checked as in read_spheres_csv(), and dropped.
RestingSpheres read_resting_spheres(LineReader lines);

/// Writes all eight columns. Throws RunError if the file cannot be written.
void write_spheres_csv(const std::filesystem::path& path, const Bodies& bodies);

}  // namespace ballpit
