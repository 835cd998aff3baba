// SPDX-License-Identifier: MIT
#include "scene/csv_header.h"

#include <fmt/format.h>

namespace ballpit {

namespace {

constexpr char kSeparators[] = {',', ';', '\t', ' '};

struct ColumnName {
  std::string_view name;
  CsvColumn column;
  double factor = 1;
};
constexpr ColumnName kNames[] = {{"x", kX},
                                 {"y", kY},
                                 {"z", kZ},
                                 {"radius", kRadius},
                                 {"r", kRadius},
                                 {"diameter", kRadius, 0.5},
                                 {"d", kRadius, 0.5},
                                 {"vx", kVx},
                                 {"vy", kVy},
                                 {"vz", kVz},
                                 {"mass", kMassColumn}};

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

const ColumnName* find_name(std::string_view name) {
  const auto* const found = std::ranges::find(kNames, lower(name), &ColumnName::name);
  return found == std::end(kNames) ? nullptr : found;
}

CsvHeader split_header(std::string_view line, char separator) {
  CsvHeader header;
  header.separator = separator;
  CsvFields fields(line, separator);
  for (std::string_view name; fields.next(name);) {
    const ColumnName* const known = find_name(name);
    header.names.emplace_back(name);
    header.columns.push_back(known != nullptr ? known->column : kIgnored);
    if (known != nullptr && known->column == kRadius) header.radius_factor = known->factor;
  }
  // Separators at the end of the line do not name columns.
  while (!header.names.empty() && header.names.back().empty()) {
    header.names.pop_back();
    header.columns.pop_back();
  }
  return header;
}

/// The first required column that the header lacks.
const ColumnName* missing(const CsvHeader& header) {
  for (const ColumnName& name : kNames) {
    if (name.column <= kRadius && !header.has(name.column)) return &name;
  }
  return nullptr;
}

void refuse_twice(const CsvHeader& header, const Place& place) {
  for (size_t k = 0; k < header.columns.size(); ++k) {
    if (header.columns[k] == kIgnored) continue;
    for (size_t first = 0; first < k; ++first) {
      if (header.columns[first] != header.columns[k]) continue;
      const std::string &a = header.names[first], &b = header.names[k];
      const bool is_same = lower(a) == lower(b);
      throw input_error(place, "header", is_same ? in_quotes(b) + " twice" : in_quotes(a) + " and " + in_quotes(b),
                        is_same ? kHeaderRule : "one of radius, r, diameter, d");
    }
  }
}

}  // namespace

std::string CsvHeader::ignored() const {
  constexpr size_t kMaxNamed = 8;
  std::string text;
  size_t count = 0;
  for (size_t k = 0; k < columns.size(); ++k) {
    if (columns[k] != kIgnored || ++count > kMaxNamed) continue;
    if (!text.empty()) text += ", ";
    text += names[k].empty() ? fmt::format("column {} without a name", k + 1) : in_quotes(names[k]);
  }
  if (count > kMaxNamed) text += fmt::format(" and {} more", count - kMaxNamed);
  return text;
}

/// A quote inside is written twice.
void CsvFields::take_quoted(std::string_view& field) {
  size_t end = rest_.find('"', 1);
  while (end != std::string_view::npos && rest_.substr(end + 1).starts_with('"')) end = rest_.find('"', end + 2);
  is_done_ = end == std::string_view::npos;
  if (is_done_) {
    field = rest_;
    fault_ = "a quote that is not closed";
    return;
  }
  field = rest_.substr(1, end - 1);
  while (!field.empty() && is_blank(field.back())) field.remove_suffix(1);
  while (!field.empty() && is_blank(field.front())) field.remove_prefix(1);
  rest_.remove_prefix(end + 1);
  const bool is_apart = !rest_.empty() && is_blank(rest_.front());
  skip_blanks();
  if (rest_.empty()) {
    is_done_ = true;
  } else if (separator_ != ' ' && rest_.front() == separator_) {
    rest_.remove_prefix(1);
  } else if (separator_ != ' ' || !is_apart) {
    fault_ = "text behind a closing quote";
    is_done_ = true;
  }
}

std::optional<CsvHeader> parse_csv_header(std::string_view line, const Place& place) {
  for (const char separator : kSeparators) {
    CsvHeader header = split_header(line, separator);
    if (missing(header) != nullptr) continue;
    refuse_twice(header, place);
    return header;
  }
  return std::nullopt;
}

UserError no_csv_header(std::string_view line, const Place& place) {
  if (line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF")) {
    return input_error(place, "header", "text in UTF-16", "text in UTF-8");
  }
  CsvHeader best;
  int64_t max = -1;
  for (const char separator : kSeparators) {
    CsvHeader header = split_header(line, separator);
    const int64_t known = std::ranges::count_if(header.columns, [](CsvColumn column) { return column != kIgnored; });
    if (known <= max) continue;
    max = known;
    best = std::move(header);
  }
  std::string found = "no column " + in_quotes(missing(best)->name);
  const size_t begin = line.find_first_not_of(" \t"), end = line.find_last_not_of(" \t");
  if (max == 0) found = in_quotes(line.substr(begin, end + 1 - begin)) + ", " + found;
  return input_error(place, "header", found, kHeaderRule);
}

}  // namespace ballpit
