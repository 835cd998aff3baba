// SPDX-License-Identifier: MIT
// The kernels of CudaExecutor::bin(): sorting indices by small keys, and finding where each key's begin.
//
//     index    0  1  2  3  4          store keys      one thread an index
//     key      1  4  1  0  4
//     keys     0  1  1  4  4          radix sort      of as many bits as the keys have (CUB)
//     order    3  0  2  1  4
//     offsets  0  1  3  3  3  5       find bins       one thread for kBinsPerThread bins
//     values   v₃ v₀ v₂ v₁ v₄         gather values   one thread an index
//
// Where the bins begin could be told by every thread that sees two neighbours in `keys` differ; but it must then fill
// in the offsets of all empty bins between, and where bodies gather in a corner of the domain, one thread would write
// almost all of them. A binary search for each bin is even, but costs log₂ n reads a bin, and most bins are empty.
// So a thread searches once, for its first bin, and gallops from there: an empty bin costs no read, a full one as many
// as its count has bits. Nobody waits for anybody, whatever the bins hold.
#pragma once

#include <cstdint>

#include "core/host_device.h"
#include "core/span.h"

namespace ballpit {

template <class KeyOf>
struct StoreKey {
  KeyOf key_of;
  Span<uint32_t> keys;
  Span<int> order;

  HOST_DEVICE void operator()(int i) const {
    keys[i] = static_cast<uint32_t>(key_of(i));
    order[i] = i;
  }
};

inline constexpr int kBinsPerThread = 8;  // their offsets are 32 bytes, which memory moves at once

/// Kernel: offsets[k] = the number of keys below k, for k = kBinsPerThread · t and those after it.
struct FindBins {
  Span<const uint32_t> keys;  ///< sorted
  Span<int> offsets;

  HOST_DEVICE void operator()(int t) const {
    const int64_t begin = int64_t(t) * kBinsPerThread, bins = offsets.size();
    const int64_t end = begin + kBinsPerThread < bins ? begin + kBinsPerThread : bins;
    int64_t at = search(static_cast<uint32_t>(begin), 0, keys.size());
    for (int64_t bin = begin; bin < end; ++bin) {
      at = gallop(static_cast<uint32_t>(bin), at);
      offsets[bin] = static_cast<int>(at);
    }
  }

 private:
  /// The first place in [low, high) whose key is not below `bin`; `high` if there is none.
  HOST_DEVICE int64_t search(uint32_t bin, int64_t low, int64_t high) const {
    while (low < high) {
      const int64_t middle = low + (high - low) / 2;
      if (keys[middle] < bin) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /// The same from `at` on, in strides that double.
  HOST_DEVICE int64_t gallop(uint32_t bin, int64_t at) const {
    const int64_t n = keys.size();
    int64_t low = at, high = at;
    for (int64_t stride = 1; high < n && keys[high] < bin; stride *= 2) {
      low = high + 1;
      high += stride;
    }
    return search(bin, low, high < n ? high : n);
  }
};

/// Kernel: the k-th value in order.
template <class ValueOf, class T>
struct GatherValue {
  ValueOf value_of;
  Span<const int> order;
  Span<T> values;
  HOST_DEVICE void operator()(int k) const { values[k] = value_of(order[k]); }
};

}  // namespace ballpit
