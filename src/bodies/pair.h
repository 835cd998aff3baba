// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

#include "core/span.h"

namespace ballpit {

/// Two bodies by index, i < j. Pairs are in canonical order by i, then j.
struct Pair {
  int32_t i;
  int32_t j;
  friend bool operator==(const Pair&, const Pair&) = default;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

/// Asks for the value of the second body of a pair that follows pair c soon. Where bodies are sorted by cells, first
/// bodies come one after another, as the cache expects, but second bodies are up to a layer of cells ahead. A GPU does
/// other work while it waits.
template <class T>
HOST_DEVICE void prefetch_second([[maybe_unused]] Span<const Pair> pairs, [[maybe_unused]] int64_t c,
                                 [[maybe_unused]] const T* values) {
  if constexpr (!kOnDevice) {
    constexpr int64_t kSoon = 16;  // pairs
    if (c + kSoon < pairs.size()) __builtin_prefetch(values + pairs[c + kSoon].j);
  }
}

}  // namespace ballpit
