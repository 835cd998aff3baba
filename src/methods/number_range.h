// SPDX-License-Identifier: MIT
// Numbers as they are typed, and the ranges that they must lie in.
#pragma once

#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace ballpit {

template <class T>
struct Range {
  T low, high;
};
template <class T>
Range(T, T) -> Range<T>;

/// As short as it can be typed: 0.004166666666666667, 1e6.
template <class T>
std::string typed(T value) {
  std::array<char, 32> text;
  std::string result(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
  if (const size_t plus = result.find("e+"); plus != result.npos) {
    result.erase(plus + 1, result.compare(plus + 2, 1, "0") == 0 ? 2 : 1);
  }
  return result;
}

/// Empty without a value.
template <class T>
std::string typed(const std::optional<T>& value) {
  return value ? typed(*value) : "";
}

/// "0 to 10".
template <class T>
std::string text_of(const Range<T>& range) {
  return typed(range.low) + " to " + typed(range.high);
}

/// The number that makes up the whole text; empty if there is none, or if it is outside of the range.
template <class T>
std::optional<T> number_in(const Range<T>& range, std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  if (!(value >= range.low && value <= range.high)) return std::nullopt;
  return value;
}

}  // namespace ballpit
