// SPDX-License-Identifier: MIT
#include "scene/spheres_csv.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "core/file.h"
#include "scene/csv_header.h"

namespace ballpit {

namespace {

constexpr Limits kLimits[kColumns] = {kAnyNumber, kAnyNumber, kAnyNumber, kPositive,
                                      kAnyNumber, kAnyNumber, kAnyNumber, kMass};

/// The row without a comment: '#' begins one at the start of a line, or after a blank.
std::string_view without_comment(std::string_view line) {
  size_t at = line.find('#');
  for (; at != std::string_view::npos; at = line.find('#', at + 1)) {
    const bool is_apart = at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t';
    const bool is_quoted = std::count(line.begin(), line.begin() + static_cast<int64_t>(at), '"') % 2 == 1;
    if (is_apart && !is_quoted) break;
  }
  return line.substr(0, at);
}

/// A spreadsheet writes its empty rows as separators.
bool is_blank(std::string_view line, char separator) {
  return std::all_of(line.begin(), line.end(), [&](char c) { return c == ' ' || c == '\t' || c == separator; });
}

/// "1,234" and "-12,345,678": commas that separate thousands in some countries and decimals in others.
bool groups_thousands(std::string_view digits) {
  if (digits.starts_with('-')) digits.remove_prefix(1);
  const size_t first = digits.find(',');
  if (first == 0 || first > 3 || digits[0] == '0') return false;
  for (digits.remove_prefix(first); !digits.empty(); digits.remove_prefix(4)) {
    if (digits.size() < 4 || digits[0] != ',' || digits.substr(1, 3).find(',') != std::string_view::npos) return false;
  }
  return true;
}

bool read_number(std::string_view digits, double& value) {
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, value);
  if (end != last || digits.empty()) return false;
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(digits).c_str(), nullptr);
  return error == std::errc() || error == std::errc::result_out_of_range;
}

const char* separator_name(char separator) {
  return separator == ',' ? "commas" : separator == ';' ? "semicolons" : separator == '\t' ? "tabs" : "blanks";
}

/// The rows below the header: numbers, checked against the limits of their columns.
class CsvRows {
 public:
  using Row = std::array<double, kColumns>;

  /// Reads the header. Throws UserError if there is none.
  explicit CsvRows(LineReader& lines) : lines_(lines) {
    find_header();
    has_line_ = next_line();
    if (!has_line_) return;
    // A comment that looks like a header may stand above the header.
    if (const auto below = is_from_comment_ ? parse_csv_header(line_, lines_.place()) : std::nullopt) {
      header_ = *below;
      has_line_ = next_line();
    }
    if (has_line_) take_row_names();
  }

  bool has(CsvColumn column) const { return header_.has(column); }

  /// For the user: the columns that are ignored; empty if there are none.
  std::string note() const {
    const std::string ignored = header_.ignored();
    if (ignored.empty()) return "";
    return visible(
        fmt::format("{}:{}: what these columns hold is ignored: {}", header_place_.file, header_place_.line, ignored));
  }

  /// Reads the next row into the entries that belong to its columns; false after the last. Throws UserError.
  bool next(Row& row) {
    if (!has_line_ && !next_line()) return false;
    has_line_ = false;
    parse(row);
    return true;
  }

  /// The place of the row that was read last.
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

  /// Reads lines up to the next row; false after the last.
  bool next_line() {
    std::string_view line;
    while (lines_.next(line)) {
      line_ = without_comment(line);
      if (!is_blank(line_, header_.separator)) return true;
    }
    return false;
  }

  /// R writes names of rows in a first column without a name.
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
        if (!field.empty()) refuse_row();  // separators at the end of a row are allowed
      } else if (header_.columns[k] != kIgnored) {
        row[header_.columns[k]] = parse_number(field, k);
      }
    }
    if (k < columns) refuse_row();
  }

  double checked(double value, std::string_view field, size_t k) {
    const CsvColumn column = header_.columns[k];
    if (column == kRadius) value *= header_.radius_factor;
    if (!kLimits[column].contains(value)) refuse_number(field, k);
    return value;
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

  bool read_decimal_comma(std::string_view field, std::string_view digits, size_t k, double& value) {
    const size_t comma = digits.find(',');
    if (comma == std::string_view::npos || digits.find('.') != std::string_view::npos) return false;
    if (header_.separator == ',' && groups_thousands(digits)) {
      refuse(k, field, "a number without separators between thousands");
    }
    std::string with_point(digits);
    with_point[comma] = '.';
    if (!read_number(with_point, value)) return false;
    note_mark(',', field, k);
    return true;
  }

  /// A file with decimal points and decimal commas is ambiguous: one of them may separate thousands.
  void note_mark(char mark, std::string_view field, size_t k) {
    if (mark_ == 0) mark_ = mark;
    if (mark_ == mark) return;
    refuse(k, field, fmt::format("a number with a decimal {}, as above", mark_ == '.' ? "point" : "comma"));
  }

  [[noreturn]] void refuse(size_t k, std::string_view field, std::string_view allowed) const {
    throw input_error(place(), header_.names[k], in_quotes(field), allowed);
  }

  [[noreturn]] void refuse_number(std::string_view field, size_t k) const {
    if (count_fields() != static_cast<int64_t>(header_.columns.size())) refuse_row();
    const Limits& limits = kLimits[header_.columns[k]];
    const double factor = header_.columns[k] == kRadius ? header_.radius_factor : 1;
    refuse(k, field, "a number, " + limits_text({limits.low / factor, limits.high / factor}));
  }

  [[noreturn]] void refuse_row() const {
    const auto fields = count_fields();
    const auto columns = static_cast<int64_t>(header_.columns.size());
    std::string allowed = fmt::format("{}, as in the header", columns);
    const bool has_other = line_.find_first_of(header_.separator == ';' ? "\t" : ";\t") != std::string_view::npos;
    if (fields > columns && header_.separator == ',') {
      allowed += ", separated by commas: numbers with decimal commas need semicolons or tabs between them";
    } else if (has_other || fields == 1) {
      allowed += fmt::format(", separated by {}", separator_name(header_.separator));
    }
    throw input_error(place(), "row", fmt::format("{} field{}", fields, fields == 1 ? "" : "s"), allowed);
  }

  LineReader& lines_;
  CsvHeader header_;
  Place header_place_;
  bool is_from_comment_ = false;  // the header
  std::string_view line_;         // the row that is read now or next
  bool has_line_ = false;         // line_ holds a row that next() has not read
  char mark_ = 0;                 // between whole numbers and decimals, as far as it is known
};

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

}  // namespace

Bodies read_spheres_csv(LineReader lines, double density, SphereLines* source) {
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
  if (source != nullptr) *source = {rows.place().file, std::move(line), true, rows.note()};
  return bodies;
}

RestingSpheres read_resting_spheres(LineReader lines) {
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
