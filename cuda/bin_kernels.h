// SPDX-License-Identifier: MIT
// The kernels of CudaExecutor::bin() and bin_few(): sorting indices by small keys, and finding where each key's begin.
//
//     index    0  1  2  3  4          store keys      one thread an index
//     key      1  4  1  0  4
//     keys     0  1  1  4  4          radix sort      of as many bits as the keys have (CUB)
//     order    3  0  2  1  4
//     offsets  0  1  3  3  3  5       find bins       one thread for kBinsPerThread bins
//     values   v₃ v₀ v₂ v₁ v₄         gather values   one thread an index
//
// A thread for each key could find where a bin starts by comparing it with the key before. But it would have to write
// the offsets of all empty bins in between: almost all of them if bodies gather in a corner of the domain. A binary
// search for each bin distributes the work evenly, but costs log₂ n reads, and most bins are empty. So each thread
// searches once, for its first bin, and gallops from there: an empty bin costs no read, a full one as many as its count
// has bits. The work is even, whatever the bins contain.
//
// Where bins hold few indices, counters take fewer passes:
//
//     counts   1  2  0  0  2          count keys      one thread an index, by atomic addition
//     offsets  0  1  3  3  3  5       scan
//     unsorted 3  2  0  4  1          place indices   one thread an index; within a bin in any order
//     order    3  0  2  1  4          rank indices    one thread an index: as many places on as lower indices share its bin
//
// A bin of k indices costs k² reads, as the tests among the spheres of a cell do.
#pragma once

#include <cstdint>

#include "core/host_device.h"
#include "core/span.h"
#include "exec/atomics.h"

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

inline constexpr int kBinsPerThread = 8;  // their offsets take 32 bytes, which memory transfers at once

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
  /// The first index in [low, high) whose key is at least `bin`; `high` if there is none.
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

/// Kernel: stores the key of index i, and counts it. `counts` are 0 before.
template <class KeyOf>
struct CountKey {
  KeyOf key_of;
  Span<int> keys, counts;

  HOST_DEVICE void operator()(int i) const {
    const int key = key_of(i);
    keys[i] = key;
    atomic_add(&counts[key], 1);
  }
};

/// Kernel: places index i anywhere in its bin. `counts` are 0 afterwards.
struct PlaceIndex {
  Span<const int> keys, offsets;
  Span<int> counts, unsorted;

  HOST_DEVICE void operator()(int i) const {
    const int key = keys[i];
    unsorted[offsets[key] + atomic_add(&counts[key], -1) - 1] = i;
  }
};

/// Kernel: sorts the k-th of the unsorted indices within its bin.
struct RankIndex {
  Span<const int> keys, offsets, unsorted;
  Span<int> order;

  HOST_DEVICE void operator()(int k) const {
    const int i = unsorted[k], key = keys[i], begin = offsets[key], end = offsets[key + 1];
    int rank = 0;
    for (int other = begin; other < end; ++other) rank += unsorted[other] < i;
    order[begin + rank] = i;
  }
};

}  // namespace ballpit
