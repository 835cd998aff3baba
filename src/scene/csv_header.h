// SPDX-License-Identifier: MIT
// The format of a CSV file of spheres, from its header: the separator of the fields and the meaning of each column.
//
//     x,y,z,radius          "","x","y","z","radius"          # x y z radius          X;Y;Z;Diameter
//     0,0,0,0.5             "1",0,0,0,0.5                    0 0 0 0.5               0;0;0;1,0
//     by hand               R                                numpy                   a spreadsheet, decimal commas
//
// The separator is the first of commas, semicolons, tabs and blanks with which the header names x, y, z and a radius. Case does
// not matter; columns with other names are ignored. docs/decisions/0025-reading-csv.md explains why we use no library.
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>

#include "scene/input_error.h"

namespace ballpit {

enum CsvColumn { kX, kY, kZ, kRadius, kVx, kVy, kVz, kMassColumn, kColumns, kIgnored = kColumns };

struct CsvHeader {
  char separator = ',';            ///< ' ' stands for any number of blanks and tabs
  std::vector<CsvColumn> columns;  ///< the meaning of each field of a row
  std::vector<std::string> names;  ///< as written
  double radius_factor = 1;        ///< from the column to a radius: 0.5 where it holds diameters

  bool has(CsvColumn column) const { return std::ranges::count(columns, column) > 0; }
  /// For the user: "column 1 without a name, "id""; empty if every column is used.
  std::string ignored() const;
};

/// The fields of a line in order, without surrounding blanks and quotes. A field in quotes may contain separators.
class CsvFields {
 public:
  CsvFields(std::string_view line, char separator) : rest_(line), separator_(separator) {
    while (!rest_.empty() && is_blank(rest_.back())) rest_.remove_suffix(1);
    is_done_ = rest_.empty();
  }

  /// Takes the next field; false after the last. Inline for speed.
  bool next(std::string_view& field) {
    if (is_done_) return false;
    skip_blanks();
    if (!rest_.empty() && rest_.front() == '"') {
      take_quoted(field);
      return true;
    }
    const size_t end = separator_ == ' ' ? rest_.find_first_of(" \t") : rest_.find(separator_);
    field = rest_.substr(0, end);
    while (!field.empty() && is_blank(field.back())) field.remove_suffix(1);
    is_done_ = end == std::string_view::npos;
    if (!is_done_) rest_.remove_prefix(end + 1);
    return true;
  }

  /// Takes the next field if it is a bare number, in a single pass; otherwise returns false and takes nothing.
  bool next_number(std::string_view& field, double& value) {
    const char* const last = rest_.data() + rest_.size();
    const auto [end, error] = std::from_chars(rest_.data(), last, value);
    if (is_done_ || error != std::errc() || (end != last && *end != separator_)) return false;
    field = {rest_.data(), end};
    is_done_ = end == last;
    rest_.remove_prefix(field.size() + (is_done_ ? 0 : 1));
    return true;
  }

  /// The error in the field taken last; nullptr if there is none.
  const char* fault() const { return fault_; }

 private:
  bool is_blank(char c) const { return c == ' ' || (c == '\t' && separator_ != '\t'); }
  void skip_blanks() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  }
  void take_quoted(std::string_view& field);

  std::string_view rest_;
  char separator_;
  bool is_done_;
  const char* fault_ = nullptr;
};

/// The header in `line`; nothing if it lacks a required column. Throws UserError for a column named twice.
std::optional<CsvHeader> parse_csv_header(std::string_view line, const Place& place);

/// The error to throw if `line` is not a header.
UserError no_csv_header(std::string_view line, const Place& place);

inline constexpr std::string_view kHeaderRule = "columns x, y, z, radius and optionally vx, vy, vz, mass";

}  // namespace ballpit
