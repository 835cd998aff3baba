// SPDX-License-Identifier: MIT
#include "scene/spheres_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <vector>

#include "core/file.h"
#include "scene/input_error.h"

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
constexpr std::string_view kHeaderRule = "columns x, y, z, radius and optionally vx, vy, vz, mass";

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// Splits off the text before `separator`; `text` keeps what follows it, nothing at the end.
std::string_view take_until(std::string_view& text, char separator) {
  const size_t end = text.find(separator);
  const std::string_view taken = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  return taken;
}

std::string_view take_line(std::string_view& text) {
  std::string_view line = take_until(text, '\n');
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The column that each field of a row belongs to.
std::vector<Column> parse_header(std::string_view line, const Place& place) {
  std::vector<Column> columns;
  std::array<bool, kColumns> seen{};
  const bool empty = trimmed(line).empty();
  for (bool more = !empty; more;) {
    more = line.find(',') != std::string_view::npos;
    const std::string_view name = trimmed(take_until(line, ','));
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

/// Reads one row into the slots that belong to its columns.
void parse_row(std::string_view line, const std::vector<Column>& columns, const Place& place,
               std::array<double, kColumns>& values) {
  const std::string_view row = line;
  for (size_t k = 0; k < columns.size(); ++k) {
    const bool last = k + 1 == columns.size();
    if (last == (line.find(',') != std::string_view::npos)) {
      const auto commas = std::count(row.begin(), row.end(), ',');
      throw input_error(place, "row", trimmed(row).empty() ? "an empty line" : std::to_string(commas + 1) + " fields",
                        std::to_string(columns.size()) + ", as in the header");
    }
    values[columns[k]] = parse_field(take_until(line, ','), columns[k], place);
  }
}

double default_mass(double sphere_radius, double density, const Place& place) {
  const double kilograms = sphere_mass(sphere_radius, density);
  if (kMass.contains(kilograms)) return kilograms;
  throw input_error(place, "radius",
                    number_text(sphere_radius) + ", which makes a mass of " + number_text(kilograms) + " kg",
                    limits_text(kMass) + " kg");
}

void append_number(std::string& text, double value, char separator) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  text.append(buffer.data(), end) += separator;
}

}  // namespace

Bodies parse_spheres_csv(std::string_view text, std::string_view file_name, double density) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  Place place{std::string(file_name), 1};
  if (text.empty()) throw input_error(place, "header", "an empty file", kHeaderRule);
  const std::vector<Column> columns = parse_header(take_line(text), place);
  const bool has_mass = std::find(columns.begin(), columns.end(), mass) != columns.end();

  Bodies bodies;
  bodies.reserve(std::count(text.begin(), text.end(), '\n') + 1);
  std::array<double, kColumns> values{};
  while (!text.empty()) {
    ++place.line;
    parse_row(take_line(text), columns, place, values);
    if (bodies.size() == kLargestCount) {
      throw input_error(place, "row", "one sphere too many", "at most " + std::to_string(kLargestCount));
    }
    bodies.position.push_back({values[x], values[y], values[z]});
    bodies.velocity.push_back({values[vx], values[vy], values[vz]});
    bodies.radius.push_back(values[radius]);
    bodies.mass.push_back(has_mass ? values[mass] : default_mass(values[radius], density, place));
  }
  return bodies;
}

Bodies read_spheres_csv(const std::filesystem::path& path, double density) {
  return parse_spheres_csv(read_file(path), path.string(), density);
}

void write_spheres_csv(const std::filesystem::path& path, const Bodies& bodies) {
  std::string text = "x,y,z,radius,vx,vy,vz,mass\n";
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    for (const double value : {bodies.position[i].x, bodies.position[i].y, bodies.position[i].z, bodies.radius[i],
                               bodies.velocity[i].x, bodies.velocity[i].y, bodies.velocity[i].z}) {
      append_number(text, value, ',');
    }
    append_number(text, bodies.mass[i], '\n');
  }
  write_file(path, text);
}

}  // namespace ballpit
