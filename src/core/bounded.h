// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace ballpit {

/// At most so many elements, where the host may not know how many (exec/deferred.h).
struct Bounded {
  int64_t most = 0;
  const int* count = nullptr;  ///< how many there are, in the executor's memory
};

}  // namespace ballpit
