// SPDX-License-Identifier: MIT
#include "scene/spheres_csv.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/file.h"
#include "core/numbers.h"
#include "scene/csv_rows.h"

namespace ballpit {

namespace {

using Row = CsvRows::Row;

/// Calls append(row) for each row. Throws UserError if there are too many.
template <class Append>
void for_each_row(CsvRows& rows, Append&& append) {
  Row row{};
  for (int64_t count = 0; rows.next(row); ++count) {
    if (count == kLargestCount) {
      throw input_error(rows.place(), "row", "one sphere too many", fmt::format("at most {}", kLargestCount));
    }
    append(row);
  }
}

int64_t expected_rows(const LineReader& lines) { return std::min(lines.expected_lines() + 1, kLargestCount); }

Bodies bodies_in(LineReader lines, double density, SphereSource* source) {
  CsvRows rows(lines);
  Bodies bodies;
  std::vector<int> line;
  bodies.reserve(expected_rows(lines));
  line.reserve(static_cast<size_t>(expected_rows(lines)));
  for_each_row(rows, [&, has_mass = rows.has(kMassColumn)](const Row& row) {
    bodies.position.push_back({row[kX], row[kY], row[kZ]});
    bodies.velocity.push_back({row[kVx], row[kVy], row[kVz]});
    bodies.radius.push_back(row[kRadius]);
    bodies.mass.push_back(has_mass ? row[kMassColumn] : default_mass(row[kRadius], density, rows.place(), "radius"));
    line.push_back(rows.place().line);
  });
  if (source != nullptr) *source = {std::move(line), rows.note()};
  return bodies;
}

RestingSpheres resting_spheres_in(LineReader lines) {
  CsvRows rows(lines);
  RestingSpheres spheres;
  spheres.position.reserve(static_cast<size_t>(expected_rows(lines)));
  spheres.radius.reserve(static_cast<size_t>(expected_rows(lines)));
  for_each_row(rows, [&](const Row& row) {
    spheres.position.push_back(narrow<Vec3>({row[kX], row[kY], row[kZ]}));
    spheres.radius.push_back(static_cast<float>(row[kRadius]));
  });
  spheres.note = rows.note();
  return spheres;
}

}  // namespace

Bodies parse_spheres_csv(std::string_view text, std::string_view file_name, double density, SphereSource* source) {
  return bodies_in(LineReader(text, file_name), density, source);
}

Bodies read_spheres_csv(const std::filesystem::path& path, double density, SphereSource* source) {
  return bodies_in(LineReader(path), density, source);
}

RestingSpheres parse_resting_spheres(std::string_view text, std::string_view file_name) {
  return resting_spheres_in(LineReader(text, file_name));
}

RestingSpheres read_resting_spheres(const std::filesystem::path& path) { return resting_spheres_in(LineReader(path)); }

void write_spheres_csv(const std::filesystem::path& path, const Bodies& bodies) {
  std::string text = "x,y,z,radius,vx,vy,vz,mass\n";
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    const Vec3d &x = bodies.position[i], &v = bodies.velocity[i];
    append_numbers(text, {x.x, x.y, x.z, bodies.radius[i], v.x, v.y, v.z, bodies.mass[i]}, ',');
    text += '\n';
  }
  write_file(path, text);
}

}  // namespace ballpit
