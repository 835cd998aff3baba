// SPDX-License-Identifier: MIT
// Arrays of random numbers, and spans of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/random.h"
#include "core/span.h"

namespace ballpit {

/// Uniform in 0 … limit − 1.
template <class T>
std::vector<T> random_values(int64_t n, uint64_t limit, uint64_t seed) {
  Random random(seed);
  std::vector<T> values(static_cast<size_t>(n));
  for (T& value : values) value = static_cast<T>(random.bits() % limit);
  return values;
}

template <class T>
Span<T> span_of(std::vector<T>& values) {
  return {values.data(), static_cast<int64_t>(values.size())};
}

}  // namespace ballpit
