// SPDX-License-Identifier: MIT
// How a CSV file of spheres is written, as its header says: what separates its fields, and what each column holds.
//
//     x,y,z,radius          "","x","y","z","radius"          # x y z radius          X;Y;Z;Diameter
//     0,0,0,0.5             "1",0,0,0,0.5                    0 0 0 0.5               0;0;0;1,0
//     by hand               R                                numpy                   a spreadsheet, decimal commas
//
// Separators are commas, semicolons, tabs or blanks: the first of them that makes the header name x, y, z and a radius.
// Names are read in any case; columns with other names are left out. Why there is no library for it:
// docs/decisions/0025-reading-csv.md.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/input_error.h"

namespace ballpit {

enum CsvColumn { kX, kY, kZ, kRadius, kVx, kVy, kVz, kMassColumn, kColumns, kIgnored = kColumns };

struct CsvHeader {
  char separator = ',';            ///< ' ' stands for any number of blanks and tabs
  std::vector<CsvColumn> columns;  ///< what each field of a row holds
  std::vector<std::string> names;  ///< as written
  double radius_factor = 1;        ///< from the column to a radius: 0.5 where it holds diameters

  bool has(CsvColumn column) const;
  /// For the user: "column 1 without a name, "id""; empty where every column is read.
  std::string ignored() const;
};

/// The fields of a line, one after the other; in quotes or not, without blanks around them. A field that begins with a
/// quote ends with one, and may hold separators.
class CsvFields {
 public:
  CsvFields(std::string_view line, char separator) : rest_(line), separator_(separator) {
    while (!rest_.empty() && is_blank(rest_.back())) rest_.remove_suffix(1);
    is_done_ = rest_.empty();
  }

  /// Takes the next field; false after the last. Inline, since a file has many.
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

  /// Takes the next field where it is a bare number; false, and nothing is taken, where it may be anything else. What
  /// most files are made of, in one pass.
  bool next_number(std::string_view& field, double& value) {
    const char* const last = rest_.data() + rest_.size();
    const auto [end, error] = std::from_chars(rest_.data(), last, value);
    if (is_done_ || error != std::errc() || (end != last && *end != separator_)) return false;
    field = {rest_.data(), end};
    is_done_ = end == last;
    rest_.remove_prefix(field.size() + (is_done_ ? 0 : 1));
    return true;
  }

  /// What is wrong with the field taken last; nullptr where nothing is.
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

/// The header in `line`; nothing where it lacks a column that is needed. Throws UserError for a column named twice.
std::optional<CsvHeader> parse_csv_header(std::string_view line, const Place& place);

/// What to throw where `line` is no header.
UserError no_csv_header(std::string_view line, const Place& place);

/// "columns x, y, z, radius and optionally vx, vy, vz, mass".
extern const std::string_view kHeaderRule;

}  // namespace ballpit
