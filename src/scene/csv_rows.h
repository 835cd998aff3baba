// SPDX-License-Identifier: MIT
// The rows of a CSV file of spheres, below its header (csv_header.h): numbers, checked against the limits of their columns.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "scene/csv_header.h"
#include "scene/line_reader.h"

namespace ballpit {

class CsvRows {
 public:
  using Row = std::array<double, kColumns>;

  /// Reads the header. Throws UserError if there is none.
  explicit CsvRows(LineReader& lines);

  bool has(CsvColumn column) const { return header_.has(column); }

  /// For the user: the columns that are ignored; empty if there are none.
  std::string note() const;

  /// Reads the next row into the entries that belong to its columns; false after the last. Throws UserError.
  bool next(Row& row);

  /// The place of the row that was read last.
  const Place& place() const { return lines_.place(); }

 private:
  void find_header();
  bool next_line();
  void take_row_names();
  int64_t count_fields() const;
  void parse(Row& row);
  double checked(double value, std::string_view field, size_t k);
  double parse_number(std::string_view field, size_t k);
  bool read_decimal_comma(std::string_view field, std::string_view digits, size_t k, double& value);
  void note_mark(char mark, std::string_view field, size_t k);
  [[noreturn]] void refuse(size_t k, std::string_view field, std::string_view allowed) const;
  [[noreturn]] void refuse_number(std::string_view field, size_t k) const;
  [[noreturn]] void refuse_row() const;

  LineReader& lines_;
  CsvHeader header_;
  Place header_place_;
  bool is_from_comment_ = false;  // the header
  std::string_view line_;         // the row that is read now or next
  bool has_line_ = false;         // line_ holds a row that next() has not read
  char mark_ = 0;                 // between whole numbers and decimals, as far as it is known
};

}  // namespace ballpit
