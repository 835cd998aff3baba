// SPDX-License-Identifier: MIT
// Tables of results, as CSV: comment lines that begin with #, a header "name [unit]", and a line a row.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ballpit {

struct Column {
  std::string name;
  std::string unit = "";  ///< "s"; empty: none
};

/// A number, or text. What is not a number (NaN) is written as an empty cell.
using Cell = std::variant<double, std::string>;

struct Table {
  std::string name;  ///< the file's stem: "times"
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
  bool is_shown = false;                ///< in the report, as well as in its file
};

/// As the audience reads it: "1 234", "0.0123", "–" for what is not a number.
std::string short_text(const Cell& cell);

/// "time [ms]"
std::string header_of(const Column& column);

/// One line, with its end. Texts with commas or quotes are quoted; numbers read back as the same doubles.
std::string csv_line(const std::vector<Cell>& cells);

/// The cells of one line, without its end, as text.
std::vector<std::string> split_csv_line(std::string_view line);

/// The whole file; `comments` stand before the header, a line each.
std::string csv_of(const Table& table, const std::vector<std::string>& comments);

}  // namespace ballpit
