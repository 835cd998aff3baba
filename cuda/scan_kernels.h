// SPDX-License-Identifier: MIT
// What CudaExecutor::exclusive_scan() passes to CUB: the counts of one array or two, and where their sums go.
#pragma once

#include <cstdint>

#include "core/host_device.h"

namespace ballpit {

/// What a scan adds up: one array, or two.
struct Sums {
  int64_t a, b;
};
struct ReadCounts {
  const int *a, *b;  ///< b may be null
  HOST_DEVICE Sums operator()(int64_t i) const { return {a[i], b == nullptr ? 0 : b[i]}; }
};
struct AddSums {
  HOST_DEVICE Sums operator()(const Sums& a, const Sums& b) const { return {a.a + b.a, a.b + b.b}; }
};

/// Receives the sums of a scan, in any order: stores them as offsets, and the last one in 64 bits.
struct StoreSums {
  int n;
  int *a, *b;  ///< b may be null
  int64_t* total;

  HOST_DEVICE void operator()(int64_t i, const Sums& sum) const {
    if (i == 0) {
      a[0] = 0;
      if (b != nullptr) b[0] = 0;
    }
    a[i + 1] = static_cast<int>(sum.a);
    if (b != nullptr) b[i + 1] = static_cast<int>(sum.b);
    if (i + 1 == n) *total = sum.a;
  }
};

}  // namespace ballpit
