// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

namespace ballpit {

/// Two bodies by index, i < j. Pairs are in canonical order by i, then j.
struct Pair {
  int32_t i;
  int32_t j;
  friend bool operator==(const Pair&, const Pair&) = default;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

}  // namespace ballpit
