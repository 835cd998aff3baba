// SPDX-License-Identifier: MIT
#include "lab/numbers.h"

#include <array>
#include <cmath>
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

}  // namespace ballpit
