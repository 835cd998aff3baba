// SPDX-License-Identifier: MIT
// The counting sort of CpuExecutor: stable, by keys in 0 … bins−1, on several threads.
//
// Indices are divided into blocks, one for each thread. A block has a counter for every bin:
//
//     keys            0 2 1 0 | 2 3 3        two blocks
//     count           2 1 1 0 | 0 0 1 2      of each block and bin
//     scan            0 2 3 4 | 2 3 4 5      where the block's part of the bin begins
//     after placing   2 3 4 4 | 2 3 5 7      where it ends: in the last block, where the bin ends
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace ballpit {

/// The counters of blocks, `bins` for each.
struct BinCounters {
  int64_t bins;
  std::vector<int*> blocks;
};

namespace counting {

struct Range {
  int64_t begin, end;

  /// The k-th of nearly equal parts of 0 … n−1.
  static Range part(int64_t n, int64_t k, int64_t parts) { return {n * k / parts, n * (k + 1) / parts}; }
};

/// From count, of all indices in lower bins, to the positions at which each block's part of a bin begins.
inline void scan_bins(const std::vector<int*>& blocks, Range bins, int count) {
  if (blocks.size() == 1) {
    int* const counts = blocks[0];
    for (int64_t bin = bins.begin; bin < bins.end; ++bin) count += std::exchange(counts[bin], count);
  } else {
    for (int64_t bin = bins.begin; bin < bins.end; ++bin) {
      for (int* const counts : blocks) count += std::exchange(counts[bin], count);
    }
  }
}

/// The same for all bins, in as many parts as there are blocks.
template <class Run>
void scan(const Run& run, const BinCounters& counters) {
  const auto parts = static_cast<int64_t>(counters.blocks.size());
  std::vector<int> sums(counters.blocks.size() + 1, 0);
  if (parts > 1) {
    run(parts, [&](int64_t k) {
      const Range bins = Range::part(counters.bins, k, parts);
      int sum = 0;
      for (const int* const counts : counters.blocks) {
#pragma omp simd reduction(+ : sum)
        for (int64_t bin = bins.begin; bin < bins.end; ++bin) sum += counts[bin];
      }
      sums[static_cast<size_t>(k) + 1] = sum;
    });
    for (size_t k = 1; k < sums.size(); ++k) sums[k] += sums[k - 1];
  }
  run(parts, [&](int64_t k) {
    scan_bins(counters.blocks, Range::part(counters.bins, k, parts), sums[static_cast<size_t>(k)]);
  });
}

}  // namespace counting

/// Calls put(i, position) for each i in 0 … n−1, with its sorted position; values of equal keys keep their order.
/// find_keys(from, to) is called for a few indices before their keys are read by key_of(i): apart from the counting,
/// such a loop can be compiled to vector instructions. run(blocks, body) calls body(b) for each block, in parallel.
template <class Run, class FindKeys, class KeyOf, class Put>
void counting_sort(const Run& run, int64_t n, const BinCounters& counters, const FindKeys& find_keys,
                   const KeyOf& key_of, const Put& put) {
  using counting::Range;
  constexpr int64_t kBatch = 256;
  const auto blocks = static_cast<int64_t>(counters.blocks.size());
  run(blocks, [&](int64_t b) {
    int* const counts = counters.blocks[static_cast<size_t>(b)];
    std::fill(counts, counts + counters.bins, 0);
    const Range block = Range::part(n, b, blocks);
    for (int64_t from = block.begin, to; from < block.end; from = to) {
      to = std::min(block.end, from + kBatch);
      find_keys(from, to);
      for (int64_t i = from; i < to; ++i) ++counts[key_of(i)];
    }
  });
  counting::scan(run, counters);
  run(blocks, [&](int64_t b) {
    int* const next = counters.blocks[static_cast<size_t>(b)];
    const Range block = Range::part(n, b, blocks);
    for (int64_t i = block.begin; i < block.end; ++i) put(i, next[key_of(i)]++);
  });
}

}  // namespace ballpit
