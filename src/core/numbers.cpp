// SPDX-License-Identifier: MIT
#include "core/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include <fmt/format.h>

#include "core/language.h"

namespace ballpit {

std::string three_digits(double value) {
  const double size = std::fabs(value);
  if (size > 0 && (size < 0.01 || size >= 1e6)) return fmt::format("{:.2e}", value);
  return fmt::format("{:.{}f}", value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

namespace {

/// "⁻⁵".
std::string superscript(int number) {
  constexpr std::array kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number))) text += kDigits.at(static_cast<size_t>(digit - '0'));
  return text;
}

}  // namespace

std::string ten_to_the(int power) {
  if (power == 0 || power == 1) return power == 0 ? "1" : "10";
  return "10" + superscript(power);
}

std::string with_unit(double value, std::string_view unit, bool is_exact) {
  constexpr std::array kPrefixes{"p", "n", "µ", "m", "", "k", "M", "G", "T"};  // 10⁻¹² to 10¹²
  constexpr int kOne = 4;                                                      // the index of no prefix
  if (!std::isfinite(value)) return unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
  if (value == 0) return unit.empty() ? "0" : fmt::format("0 {}", unit);
  const int power = static_cast<int>(std::floor(std::log10(std::fabs(value) * (1 + 1e-12))));
  const auto digits = [&](double number) {
    return local_number(is_exact ? fmt::format("{:.3g}", number) : three_digits(number));
  };
  if (power >= -2 && power < 3 && unit.empty()) return digits(value);
  const int thousands = static_cast<int>(std::floor(power / 3.0));
  if (!unit.empty() && thousands >= -kOne && thousands <= kOne) {
    const char* const prefix = kPrefixes.at(static_cast<size_t>(thousands + kOne));
    return digits(value / std::pow(1000.0, thousands)) + " " + prefix + std::string(unit);
  }
  const std::string number =
      local_number(fmt::format("{:.2f}", value / std::pow(10.0, power))) + " × 10" + superscript(power);
  return unit.empty() ? number : number + " " + std::string(unit);
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
