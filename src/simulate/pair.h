// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace ballpit {

/// Two bodies by index, i < j.
struct Pair {
  int32_t i;
  int32_t j;
  friend bool operator==(const Pair&, const Pair&) = default;
};

}  // namespace ballpit
