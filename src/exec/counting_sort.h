// SPDX-License-Identifier: MIT
// The counting sort of CpuExecutor: stable, by keys in 0 … bins−1, on several threads.
//
// Indices are divided into blocks, one for each thread. A block has a counter for every bin:
//
//     keys            0 2 1 0 | 2 3 3        two blocks
//     count           2 1 1 0 | 0 0 1 2      of each block and bin
//     scan            0 2 3 4 | 2 3 4 5      where the block's part of the bin begins
//     after placing   2 3 4 4 | 2 3 5 7      where it ends: in the last block, where the bin ends
//
// Where keys are nearly sorted, bins are divided instead: KeyParts.
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

/// Keys in blocks, and their bins in parts, one for each thread. Where keys are nearly sorted, most blocks have keys of
/// one part alone. Then each thread counts, scans and places those of its part: only its own part of the counters is in
/// its cache.
///
///     keys      0 1 0 | 2 1 3 | 4 5 4      blocks
///     parts     bins 0 … 2 | 3 … 5         the second block has keys of both
class KeyParts {
 public:
  /// Finds keys[i], in 0 … bins−1, for each i in 0 … n−1, as counting_sort() does, in parallel.
  template <class Run, class FindKeys>
  KeyParts(const Run& run, int64_t n, const int* keys, int64_t bins, int parts, const FindKeys& find_keys)
      : keys_(keys), blocks_(static_cast<size_t>((n + kBlock - 1) / kBlock)) {
    run(static_cast<int64_t>(blocks_.size()), [&](int64_t b) {
      const int64_t begin = b * kBlock, end = std::min(n, begin + kBlock);
      find_keys(begin, end);
      int least = keys[begin], greatest = least;
#pragma omp simd reduction(min : least) reduction(max : greatest)
      for (int64_t i = begin; i < end; ++i) {
        least = std::min(least, keys[i]);
        greatest = std::max(greatest, keys[i]);
      }
      blocks_[static_cast<size_t>(b)] = {begin, end, least, greatest};
    });
    // Parts begin at keys in the middle of blocks, so that they have about as many keys.
    std::vector<int> middles;
    for (const Block& block : blocks_) middles.push_back(block.least + (block.greatest - block.least) / 2);
    std::sort(middles.begin(), middles.end());
    starts_.push_back(0);
    for (size_t part = 1; part < static_cast<size_t>(parts) && n > 0; ++part) {
      starts_.push_back(middles[middles.size() * part / static_cast<size_t>(parts)]);
    }
    starts_.push_back(static_cast<int>(bins));
  }

  /// Whether most keys are looked at by one thread alone.
  bool are_apart() const {
    int64_t looks = 0, keys = 0;
    for (const Block& block : blocks_) {
      keys += block.end - block.begin;
      for (size_t part = 0; part + 1 < starts_.size(); ++part) {
        if (block.overlaps(starts_[part], starts_[part + 1])) looks += block.end - block.begin;
      }
    }
    return 4 * looks <= 5 * keys;
  }

  /// Calls put(i, position) as counting_sort() does, and leaves in ends[bin] where the bin ends.
  template <class Run, class Put>
  void sort(const Run& run, int* ends, const Put& put) const {
    run(static_cast<int64_t>(starts_.size()) - 1, [&](int64_t part) {
      const int begin = starts_[static_cast<size_t>(part)], end = starts_[static_cast<size_t>(part) + 1];
      std::fill(ends + begin, ends + end, 0);
      for_each(begin, end, [&](int64_t i) { ++ends[keys_[i]]; });
      counting::scan_bins({ends}, {begin, end}, count_below(begin));
      for_each(begin, end, [&](int64_t i) { put(i, ends[keys_[i]]++); });
    });
  }

 private:
  static constexpr int64_t kBlock = 4096;

  struct Block {
    int64_t begin, end;
    int least, greatest;

    bool overlaps(int bin, int end_bin) const { return least < end_bin && greatest >= bin; }
    bool lies_in(int bin, int end_bin) const { return least >= bin && greatest < end_bin; }
  };

  /// Calls visit(i), in order, for each key in begin … end−1.
  template <class Visit>
  void for_each(int begin, int end, const Visit& visit) const {
    for (const Block& block : blocks_) {
      if (block.lies_in(begin, end)) {
        for (int64_t i = block.begin; i < block.end; ++i) visit(i);
      } else if (block.overlaps(begin, end)) {
        for (int64_t i = block.begin; i < block.end; ++i) {
          if (keys_[i] >= begin && keys_[i] < end) visit(i);
        }
      }
    }
  }

  int count_below(int bin) const {
    int count = 0;
    for (const Block& block : blocks_) {
      if (block.greatest < bin) {
        count += static_cast<int>(block.end - block.begin);
      } else if (block.least < bin) {
        for (int64_t i = block.begin; i < block.end; ++i) count += keys_[i] < bin;
      }
    }
    return count;
  }

  const int* keys_;
  std::vector<Block> blocks_;
  std::vector<int> starts_;  // of each part, and the number of bins
};

}  // namespace ballpit
