// SPDX-License-Identifier: MIT
#include "core/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace ballpit {

std::string three_digits(double value) {
  const double size = std::fabs(value);
  if (size > 0 && (size < 0.01 || size >= 1e6)) return fmt::format("{:.2e}", value);
  return fmt::format("{:.{}f}", value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

std::string grouped(int64_t number) {
  std::string digits = std::to_string(number);
  const std::ptrdiff_t sign = number < 0;
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > sign; at -= 3) {
    digits.insert(static_cast<size_t>(at), "\u2009");
  }
  return digits;
}

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void append_number(std::string& text, double value) {
  // Not by fmt, which writes 100000 where 1e+05 is shorter.
  std::array<char, 32> buffer;
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

void append_numbers(std::string& text, std::initializer_list<double> values, char separator) {
  for (const double* value = values.begin(); value != values.end(); ++value) {
    if (value != values.begin()) text += separator;
    append_number(text, *value);
  }
}

}  // namespace ballpit
