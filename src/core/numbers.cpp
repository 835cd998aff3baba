// SPDX-License-Identifier: MIT
#include "core/numbers.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace ballpit {

std::string three_digits(double value) {
  std::array<char, 32> text;
  const double size = std::fabs(value);
  if (size > 0 && (size < 0.01 || size >= 1e6)) {
    std::snprintf(text.data(), text.size(), "%.2e", value);
  } else {
    const int decimals = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  }
  return text.data();
}

std::string grouped(int64_t number) {
  std::string digits = std::to_string(number);
  const std::ptrdiff_t sign = number < 0;
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > sign; at -= 3) {
    digits.insert(static_cast<size_t>(at), "\u2009");
  }
  return digits;
}

}  // namespace ballpit
