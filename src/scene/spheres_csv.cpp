// SPDX-License-Identifier: MIT
#include "scene/spheres_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>
#include <vector>

#include "core/append_number.h"
#include "core/file.h"
#include "scene/input_error.h"
#include "scene/line_reader.h"

namespace ballpit {

namespace {

enum Column { x, y, z, radius, vx, vy, vz, mass, kColumns };
constexpr int kRequired = 4;  // x, y, z, radius

struct ColumnRule {
  std::string_view name;
  Limits limits;
};
constexpr ColumnRule kRules[kColumns] = {{"x", kAnyNumber},     {"y", kAnyNumber},  {"z", kAnyNumber},
                                         {"radius", kPositive}, {"vx", kAnyNumber}, {"vy", kAnyNumber},
                                         {"vz", kAnyNumber},    {"mass", kMass}};
using Row = std::array<double, kColumns>;
constexpr std::string_view kHeaderRule = "columns x, y, z, radius and optionally vx, vy, vz, mass";

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// Splits off the text before the next comma; `text` keeps what follows it, nothing at the end.
std::string_view take_field(std::string_view& text) {
  const std::string_view field = text.substr(0, text.find(','));
  text.remove_prefix(std::min(field.size() + 1, text.size()));
  return field;
}

/// The column that each field of a row belongs to.
std::vector<Column> parse_header(std::string_view line, const Place& place) {
  std::vector<Column> columns;
  std::array<bool, kColumns> seen{};
  const bool empty = trimmed(line).empty();
  for (bool more = !empty; more;) {
    more = line.find(',') != std::string_view::npos;
    const std::string_view name = trimmed(take_field(line));
    int column = 0;
    while (column < kColumns && kRules[column].name != name) ++column;
    if (column == kColumns) throw input_error(place, "header", quoted(name), kHeaderRule);
    if (seen[static_cast<size_t>(column)]) {
      throw input_error(place, "header", quoted(name) + " twice", kHeaderRule);
    }
    seen[static_cast<size_t>(column)] = true;
    columns.push_back(static_cast<Column>(column));
  }
  for (int column = 0; column < kRequired; ++column) {
    if (seen[static_cast<size_t>(column)]) continue;
    throw input_error(place, "header", "no column " + quoted(kRules[column].name), kHeaderRule);
  }
  return columns;
}

double parse_field(std::string_view field, Column column, const Place& place) {
  const ColumnRule& rule = kRules[column];
  std::string_view digits = trimmed(field);
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc() && end == digits.data() + digits.size() && rule.limits.contains(value)) return value;
  throw input_error(place, rule.name, quoted(trimmed(field)), "a number, " + limits_text(rule.limits));
}

[[noreturn]] void refuse_row(std::string_view row, size_t columns, const Place& place) {
  const auto commas = std::count(row.begin(), row.end(), ',');
  throw input_error(place, "row", trimmed(row).empty() ? "an empty line" : std::to_string(commas + 1) + " fields",
                    std::to_string(columns) + ", as in the header");
}

/// Reads one row into the slots that belong to its columns.
void parse_row(std::string_view line, const std::vector<Column>& columns, const Place& place, Row& row) {
  std::string_view rest = line;
  for (size_t k = 0; k < columns.size(); ++k) {
    const size_t end = rest.find(',');
    const bool is_last = k + 1 == columns.size();
    if (is_last != (end == std::string_view::npos)) refuse_row(line, columns.size(), place);
    row[columns[k]] = parse_field(rest.substr(0, end), columns[k], place);
    rest.remove_prefix(is_last ? rest.size() : end + 1);
  }
}

/// Hands every row of the lines to `spheres`, which is told first what will come.
template <class Spheres>
void parse_rows(LineReader& lines, Spheres& spheres) {
  std::string_view line;
  if (!lines.next(line)) throw input_error({lines.place().file, 1}, "header", "an empty file", kHeaderRule);
  const std::vector<Column> columns = parse_header(line, lines.place());
  const bool has_mass = std::find(columns.begin(), columns.end(), mass) != columns.end();
  spheres.expect(std::min(lines.expected_lines(), kLargestCount), has_mass);
  Row row{};
  for (int64_t count = 0; lines.next(line); ++count) {
    parse_row(line, columns, lines.place(), row);
    if (count == kLargestCount) {
      throw input_error(lines.place(), "row", "one sphere too many", "at most " + std::to_string(kLargestCount));
    }
    spheres.append(row, lines.place());
  }
}

double default_mass(double sphere_radius, double density, const Place& place) {
  const double kilograms = sphere_mass(sphere_radius, density);
  if (kMass.contains(kilograms)) return kilograms;
  throw input_error(place, "radius",
                    number_text(sphere_radius) + ", which makes a mass of " + number_text(kilograms) + " kg",
                    limits_text(kMass) + " kg");
}

/// Rows become bodies.
struct BodyRows {
  double density;  ///< [kg/m³]
  Bodies bodies{};
  bool has_mass = false;

  void expect(int64_t count, bool mass_is_given) {
    bodies.reserve(count);
    has_mass = mass_is_given;
  }
  void append(const Row& row, const Place& place) {
    bodies.position.push_back({row[x], row[y], row[z]});
    bodies.velocity.push_back({row[vx], row[vy], row[vz]});
    bodies.radius.push_back(row[radius]);
    bodies.mass.push_back(has_mass ? row[mass] : default_mass(row[radius], density, place));
  }
};

/// Rows become centres and radii.
struct RestingRows {
  RestingSpheres spheres{};

  void expect(int64_t count, bool) {
    spheres.position.reserve(static_cast<size_t>(count));
    spheres.radius.reserve(static_cast<size_t>(count));
  }
  void append(const Row& row, const Place&) {
    spheres.position.push_back(narrow<Vec3>({row[x], row[y], row[z]}));
    spheres.radius.push_back(static_cast<float>(row[radius]));
  }
};

Bodies bodies_in(LineReader lines, double density) {
  BodyRows rows{density};
  parse_rows(lines, rows);
  return std::move(rows.bodies);
}

RestingSpheres resting_spheres_in(LineReader lines) {
  RestingRows rows;
  parse_rows(lines, rows);
  return std::move(rows.spheres);
}

}  // namespace

Bodies parse_spheres_csv(std::string_view text, std::string_view file_name, double density) {
  return bodies_in(LineReader(text, file_name), density);
}

Bodies read_spheres_csv(const std::filesystem::path& path, double density) {
  return bodies_in(LineReader(path), density);
}

RestingSpheres parse_resting_spheres(std::string_view text, std::string_view file_name) {
  return resting_spheres_in(LineReader(text, file_name));
}

RestingSpheres read_resting_spheres(const std::filesystem::path& path) { return resting_spheres_in(LineReader(path)); }

void write_spheres_csv(const std::filesystem::path& path, const Bodies& bodies) {
  std::string text = "x,y,z,radius,vx,vy,vz,mass\n";
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    for (const double value : {bodies.position[i].x, bodies.position[i].y, bodies.position[i].z, bodies.radius[i],
                               bodies.velocity[i].x, bodies.velocity[i].y, bodies.velocity[i].z}) {
      append_number(text, value);
      text += ',';
    }
    append_number(text, bodies.mass[i]);
    text += '\n';
  }
  write_file(path, text);
}

}  // namespace ballpit
