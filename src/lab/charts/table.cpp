// SPDX-License-Identifier: MIT
#include "lab/charts/table.h"

#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "core/numbers.h"

namespace ballpit {

void Table::add_columns(const std::vector<std::string>& headers, const std::string& method) {
  for (const std::string& header : headers) columns.push_back(fmt::format(fmt::runtime(header), method));
}

std::string short_text(const Cell& cell) {
  if (const std::string* text = std::get_if<std::string>(&cell)) return *text;
  const double number = std::get<double>(cell);
  const bool is_count = std::fabs(number) < 1e15 && number == std::round(number);
  if (std::isnan(number)) return "–";
  if (std::fabs(number) >= 1e-4 && std::fabs(number) < 0.01) return number_text(std::round(number * 1e6) / 1e6);
  return is_count ? grouped(static_cast<int64_t>(number)) : three_digits(number);
}

std::string csv_line(const std::vector<Cell>& cells) {
  std::string line;
  for (const Cell& cell : cells) {
    if (&cell != &cells.front()) line += ',';
    if (const double* number = std::get_if<double>(&cell)) {
      if (!std::isnan(*number)) append_number(line, *number);
      continue;
    }
    const std::string& text = std::get<std::string>(cell);
    const std::string_view quote = text.find_first_of(",\"\n") == std::string::npos ? "" : "\"";
    line += quote;
    for (const char c : text) line.append(c == '"' ? 2 : 1, c);
    line += quote;
  }
  return line + '\n';
}

std::vector<std::string> split_csv_line(std::string_view line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '"' && is_quoted && k + 1 < line.size() && line[k + 1] == '"') {
      cells.back() += line[++k];
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

std::string csv_of(const Table& table, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += "# " + comment + '\n';
  text += csv_line({table.columns.begin(), table.columns.end()});
  for (const std::vector<Cell>& row : table.rows) {
    assert(row.size() == table.columns.size());
    text += csv_line(row);
  }
  return text;
}

}  // namespace ballpit
