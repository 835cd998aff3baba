// SPDX-License-Identifier: MIT
#include "scene/spheres_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "core/append_number.h"
#include "core/file.h"
#include "scene/csv_header.h"
#include "scene/input_error.h"
#include "scene/line_reader.h"

namespace ballpit {

namespace {

constexpr Limits kLimits[kColumns] = {kAnyNumber, kAnyNumber, kAnyNumber, kPositive,
                                      kAnyNumber, kAnyNumber, kAnyNumber, kMass};
using Row = std::array<double, kColumns>;

/// What a row says, without a comment behind it: '#' begins one at the start of a line, or behind a blank.
std::string_view without_comment(std::string_view line) {
  size_t at = line.find('#');
  for (; at != std::string_view::npos; at = line.find('#', at + 1)) {
    const bool is_apart = at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t';
    const bool is_quoted = std::count(line.begin(), line.begin() + static_cast<int64_t>(at), '"') % 2 == 1;
    if (is_apart && !is_quoted) break;
  }
  return line.substr(0, at);
}

/// A spreadsheet writes its empty rows as separators alone.
bool is_blank(std::string_view line, char separator) {
  return std::all_of(line.begin(), line.end(), [&](char c) { return c == ' ' || c == '\t' || c == separator; });
}

/// "1,234" and "-12,345,678": what separates thousands in one country, and decimals in another.
bool groups_thousands(std::string_view digits) {
  if (digits.starts_with('-')) digits.remove_prefix(1);
  const size_t first = digits.find(',');
  if (first == 0 || first > 3 || digits[0] == '0') return false;
  for (digits.remove_prefix(first); !digits.empty(); digits.remove_prefix(4)) {
    if (digits.size() < 4 || digits[0] != ',' || digits.substr(1, 3).find(',') != std::string_view::npos) return false;
  }
  return true;
}

/// The rows of a file, below its header.
class Rows {
 public:
  /// Reads up to the header, and what follows it as far as is needed to know it.
  explicit Rows(LineReader& lines) : lines_(lines) {
    find_header();
    has_row_ = next_line();
    if (!has_row_) return;
    // A comment may look like a header, and stand above one.
    if (const auto below = is_from_comment_ ? parse_csv_header(line_, lines_.place()) : std::nullopt) {
      header_ = *below;
      has_row_ = next_line();
    }
    if (has_row_) take_row_names();
  }

  const CsvHeader& header() const { return header_; }

  /// What is left out, for the user; empty where nothing is.
  std::string note() const {
    const std::string ignored = header_.ignored();
    if (ignored.empty()) return "";
    return visible(header_place_.file + ':' + std::to_string(header_place_.line) +
                   ": what these columns hold is ignored: " + ignored);
  }

  /// Reads the next row into the slots that belong to its columns; false after the last.
  bool next(Row& row) {
    if (!has_row_) return false;
    parse(row);
    return true;
  }
  /// To be called after each row.
  void advance() { has_row_ = next_line(); }

  const Place& place() const { return lines_.place(); }

 private:
  void find_header() {
    bool is_empty = true;
    std::string_view line;
    while (lines_.next(line)) {
      header_place_ = lines_.place();
      const size_t begin = line.find_first_not_of(" \t");
      if (begin == std::string_view::npos || is_blank(line, ';') || is_blank(line, ',')) continue;
      is_empty = false;
      if (line.size() == 5 && (line.starts_with("sep=") || line.starts_with("SEP="))) continue;  // for Excel
      is_from_comment_ = line[begin] == '#';
      if (is_from_comment_) line.remove_prefix(std::min(line.find_first_not_of("# \t"), line.size()));
      if (const auto header = parse_csv_header(line, lines_.place())) {
        header_ = *header;
        return;
      }
      if (!is_from_comment_) throw no_csv_header(line, lines_.place());
    }
    throw input_error({lines_.place().file, 1}, "header", is_empty ? "an empty file" : "comments alone", kHeaderRule);
  }

  bool next_line() {
    std::string_view line;
    while (lines_.next(line)) {
      line_ = without_comment(line);
      if (!is_blank(line_, header_.separator)) return true;
    }
    return false;
  }

  /// R writes the names of rows without a name for their column.
  void take_row_names() {
    if (!line_.starts_with('"') || count_fields() != static_cast<int64_t>(header_.columns.size()) + 1) return;
    header_.columns.insert(header_.columns.begin(), kIgnored);
    header_.names.emplace(header_.names.begin(), "");
  }

  int64_t count_fields() const {
    int64_t count = 0;
    CsvFields fields(line_, header_.separator);
    for (std::string_view field; fields.next(field);) ++count;
    return count;
  }

  void parse(Row& row) {
    const size_t columns = header_.columns.size();
    CsvFields fields(line_, header_.separator);
    size_t k = 0;
    std::string_view field;
    if (header_.separator == ',') {
      for (double value; k < columns && header_.columns[k] != kIgnored && fields.next_number(field, value); ++k) {
        row[header_.columns[k]] = checked(value, field, k);
      }
    }
    for (; fields.next(field); ++k) {
      if (fields.fault() != nullptr) {
        throw input_error(place(), k < columns ? header_.names[k] : "row", fields.fault(),
                          "quotes around whole fields");
      }
      if (k >= columns) {
        if (!field.empty()) refuse_row();  // separators at the end of a row do no harm
      } else if (header_.columns[k] != kIgnored) {
        row[header_.columns[k]] = parse_number(field, k);
      }
    }
    if (k < columns) refuse_row();
  }

  double parse_number(std::string_view field, size_t k) {
    std::string_view digits = field;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    double value = 0;
    const bool is_number = read_number(digits, value) || read_decimal_comma(field, digits, k, value);
    if (header_.separator != ',' && digits.find('.') != std::string_view::npos) note_mark('.', field, k);
    if (!is_number) refuse_number(field, k);
    return checked(value, field, k);
  }

  double checked(double value, std::string_view field, size_t k) {
    const CsvColumn column = header_.columns[k];
    if (column == kRadius) value *= header_.radius_factor;
    if (!kLimits[column].contains(value)) refuse_number(field, k);
    return value;
  }

  static bool read_number(std::string_view digits, double& value) {
    const char* const last = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), last, value);
    if (end != last || digits.empty()) return false;
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(digits).c_str(), nullptr);
    return error == std::errc() || error == std::errc::result_out_of_range;
  }

  bool read_decimal_comma(std::string_view field, std::string_view digits, size_t k, double& value) {
    const size_t comma = digits.find(',');
    if (comma == std::string_view::npos || digits.find('.') != std::string_view::npos) return false;
    if (header_.separator == ',' && groups_thousands(digits)) {
      throw input_error(place(), header_.names[k], quoted(field), "a number without separators between thousands");
    }
    std::string with_point(digits);
    with_point[comma] = '.';
    if (!read_number(with_point, value)) return false;
    note_mark(',', field, k);
    return true;
  }

  /// A file that has both is not understood: in one of them, they separate thousands.
  void note_mark(char mark, std::string_view field, size_t k) {
    if (mark_ == 0) mark_ = mark;
    if (mark_ == mark) return;
    throw input_error(
        place(), header_.names[k], quoted(field),
        mark_ == '.' ? "a number with a decimal point, as above" : "a number with a decimal comma, as above");
  }

  [[noreturn]] void refuse_number(std::string_view field, size_t k) {
    const auto fields = count_fields();
    if (fields != static_cast<int64_t>(header_.columns.size())) refuse_row();
    Limits limits = kLimits[header_.columns[k]];
    if (header_.columns[k] == kRadius)
      limits = {limits.low / header_.radius_factor, limits.high / header_.radius_factor};
    throw input_error(place(), header_.names[k], quoted(field), "a number, " + limits_text(limits));
  }

  [[noreturn]] void refuse_row() {
    const auto fields = count_fields();
    const auto columns = static_cast<int64_t>(header_.columns.size());
    std::string allowed = std::to_string(columns) + ", as in the header";
    const bool has_other = line_.find_first_of(header_.separator == ';' ? "\t" : ";\t") != std::string_view::npos;
    if (fields > columns && header_.separator == ',') {
      allowed += ", separated by commas: numbers with decimal commas need semicolons or tabs between them";
    } else if (has_other || fields == 1) {
      allowed += std::string(", separated by ") + (header_.separator == ','    ? "commas"
                                                   : header_.separator == ';'  ? "semicolons"
                                                   : header_.separator == '\t' ? "tabs"
                                                                               : "blanks");
    }
    throw input_error(place(), "row", std::to_string(fields) + (fields == 1 ? " field" : " fields"), allowed);
  }

  LineReader& lines_;
  CsvHeader header_;
  Place header_place_;
  bool is_from_comment_ = false;
  std::string_view line_;  // the row to be read next
  bool has_row_ = false;
  char mark_ = 0;  // between whole numbers and decimals, as far as it is known
};

/// Hands every row of the lines to `spheres`, which is told first what will come. Returns what the user is to know.
template <class Spheres>
std::string parse_rows(LineReader& lines, Spheres& spheres) {
  Rows rows(lines);
  spheres.expect(std::min(lines.expected_lines() + 1, kLargestCount), rows.header().has(kMassColumn));
  Row row{};
  for (int64_t count = 0; rows.next(row); ++count, rows.advance()) {
    if (count == kLargestCount) {
      throw input_error(rows.place(), "row", "one sphere too many", "at most " + std::to_string(kLargestCount));
    }
    spheres.append(row, rows.place());
  }
  return rows.note();
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
  std::vector<int> line{};
  bool has_mass = false;

  void expect(int64_t count, bool mass_is_given) {
    bodies.reserve(count);
    line.reserve(static_cast<size_t>(count));
    has_mass = mass_is_given;
  }
  void append(const Row& row, const Place& place) {
    bodies.position.push_back({row[kX], row[kY], row[kZ]});
    bodies.velocity.push_back({row[kVx], row[kVy], row[kVz]});
    bodies.radius.push_back(row[kRadius]);
    bodies.mass.push_back(has_mass ? row[kMassColumn] : default_mass(row[kRadius], density, place));
    line.push_back(place.line);
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
    spheres.position.push_back(narrow<Vec3>({row[kX], row[kY], row[kZ]}));
    spheres.radius.push_back(static_cast<float>(row[kRadius]));
  }
};

Bodies bodies_in(LineReader lines, double density, SphereSource* source) {
  BodyRows rows{density};
  std::string note = parse_rows(lines, rows);
  if (source != nullptr) *source = {std::move(rows.line), std::move(note)};
  return std::move(rows.bodies);
}

RestingSpheres resting_spheres_in(LineReader lines) {
  RestingRows rows;
  std::string note = parse_rows(lines, rows);
  rows.spheres.note = std::move(note);
  return std::move(rows.spheres);
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
