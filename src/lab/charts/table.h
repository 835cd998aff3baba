// SPDX-License-Identifier: MIT
// Tables of results, written as CSV: comment lines that start with #, a header "name [unit]", one line per row.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace ballpit {

/// A number or a text. NaN is written as an empty cell.
using Cell = std::variant<double, std::string>;

inline Cell cell_of(const Cell& cell) { return cell; }

/// A number of any type, or a text of any type, as a cell.
template <class Value>
Cell cell_of(const Value& value) {
  if constexpr (std::is_arithmetic_v<Value>) {
    return static_cast<double>(value);
  } else {
    return std::string(value);
  }
}

struct Table {
  std::string name;                          ///< the file's stem: "times"
  std::vector<std::string> columns;          ///< headers: "time [ms]"
  std::vector<std::vector<Cell>> rows = {};  ///< each as long as `columns`
  bool is_shown = false;                     ///< in the report too, not only in its file

  /// Columns of a method, whose name replaces the {} in the headers.
  void add_columns(const std::vector<std::string>& headers, const std::string& method);

  template <class... Values>
  void add_row(const Values&... values) {
    rows.push_back({cell_of(values)...});
  }
};

/// For readers: "1 234", "0.0123", "–" for NaN.
std::string short_text(const Cell& cell);

/// One line, with its end. Texts that contain commas or quotes are quoted; numbers read back as the same doubles.
std::string csv_line(const std::vector<Cell>& cells);

/// The cells of one line without its end, as text.
std::vector<std::string> split_csv_line(std::string_view line);

/// The whole file; `comments` come before the header, one per line.
std::string csv_of(const Table& table, const std::vector<std::string>& comments);

/// The key of a measurement: everything that it depends on, as a line of CSV without its end.
template <class... Parts>
std::string key_of(const Parts&... parts) {
  std::string line = csv_line({cell_of(parts)...});
  line.pop_back();
  return line;
}

}  // namespace ballpit
