// SPDX-License-Identifier: MIT
// The interface of executors, and its implementation on all cores by oneTBB.
//
// A method is a template over its executor and calls
//     exec.parallel_for("link bodies", n, LinkBody{…})      kernel(i) for each i in 0 … n−1, in any order, in parallel
//     exec.run_phases("solve", most, phases)                several phases in one launch: phases.h
//     exec.fill("clear cells", span, −1)                    sets all elements
//     exec.clear(span)                                      sets integers to 0
//     exec.exclusive_scan("offsets", counts, offsets)       offsets[i] = counts[0] + … + counts[i−1]; returns the total
//     exec.sort_pairs("sort endpoints", keys, values)       stable, by unsigned key
//     exec.bin("sort by cell", key_of, offsets, order)      indices sorted by small keys, stable; each key's start
//     exec.bin_few("…", key_of, offsets, order)             the same where bins hold few
//     exec.bin("…", key_of, value_of, offsets, values)      the same for values of the indices
//     exec.exclusive_scan("…", a, b, a_offsets, b_offsets)  the same of two arrays with equal totals
//     exec.upload(buffer, host) / exec.download(span)       copies from and to the host
// and reduce() of exec/reduce.h. Results do not depend on the number of threads. Every launch is timed under its name.
// Its sibling is CudaExecutor in cuda/.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "exec/counting_sort.h"
#include "exec/deferred.h"
#include "exec/fill_values.h"
#include "exec/host_buffer.h"
#include "exec/phases.h"
#include "exec/stage_times.h"
#include "exec/thread_pool.h"

namespace ballpit {

class CpuExecutor {
 public:
  template <class T>
  using Buffer = HostBuffer<T>;

  /// Runs on `threads` threads, even if there are fewer cores; 0 means all cores.
  explicit CpuExecutor(int threads) : pool_(threads) {}

  int threads() const { return pool_.threads(); }

  /// Whether kernels run one index after the other.
  bool runs_in_order() const { return threads() == 1; }
  StageTimes& stage_times() { return times_; }

  // Nothing is deferred (deferred.h), and atomic operations cost more than sorting.
  static constexpr bool kDefers = false;
  static constexpr bool is_deferring() { return false; }
  static constexpr Halt halt() { return {}; }

  /// Calls kernel(i) for each i in 0 … n−1. Kernels that change the same element must use exec/atomics.h. A kernel
  /// that works on the i-th elements of arrays, with no branch that depends on i, declares kIsElementwise: it is
  /// compiled to vector instructions.
  template <class Kernel>
  void parallel_for(const char* name, int64_t n, const Kernel& kernel) {
    const StageTimer timer(times_, name);
    run(n, kGrain, kernel);
  }

  template <class Kernel>
  void parallel_for(const char* name, const Bounded& n, const Kernel& kernel) {
    parallel_for(name, n.most, kernel);
  }

  /// Calls body(b) for each b in 0 … blocks−1: for loops that are already divided into blocks.
  template <class Body>
  void parallel_for_blocks(const char* name, int64_t blocks, const Body& body) {
    const StageTimer timer(times_, name);
    run(blocks, 1, [&](int64_t b) { body(b); });
  }

  template <Phases P>
  void run_phases(const char* name, int64_t /*most*/, P phases) {
    const StageTimer timer(times_, name);
    while (phases.next()) run(phases.size(), kGrain, phases);
  }

  template <class T>
  void fill(const char* name, Span<T> span, T value) {
    parallel_for(name, span.size(), FillValues<T>{span, value});
  }

  void clear(Span<int> span) { fill("clear", span, 0); }

  /// offsets[i] = counts[0] + … + counts[i−1] for i in 0 … n, so offsets has one element more than counts. Returns the
  /// total in 64 bits: if an int cannot hold it, the offsets are invalid and the caller must report it.
  int64_t exclusive_scan(const char* name, Span<const int> counts, Span<int> offsets) {
    const StageTimer timer(times_, name);
    const int64_t n = counts.size(), blocks = (n + kScanBlock - 1) / kScanBlock;
    std::vector<int64_t> starts(static_cast<size_t>(blocks) + 1, 0);
    run(blocks, 1, [&](int block) {
      int64_t sum = 0;
      for (int64_t i = block * kScanBlock; i < std::min(n, (block + 1) * kScanBlock); ++i) sum += counts[i];
      starts[static_cast<size_t>(block) + 1] = sum;
    });
    for (int64_t block = 0; block < blocks; ++block) starts[block + 1] += starts[block];
    run(blocks, 1, [&](int block) {
      int64_t sum = starts[static_cast<size_t>(block)];
      for (int64_t i = block * kScanBlock; i < std::min(n, (block + 1) * kScanBlock); ++i) {
        offsets[i] = static_cast<int>(sum);
        sum += counts[i];
      }
    });
    offsets[n] = static_cast<int>(starts.back());
    return starts.back();
  }

  int64_t exclusive_scan(const char* name, Span<const int> a, Span<const int> b, Span<int> a_offsets,
                         Span<int> b_offsets) {
    exclusive_scan(name, a, a_offsets);
    return exclusive_scan(name, b, b_offsets);
  }

  /// Sorts values by the lowest `bits` bits of their keys; values of equal keys keep their order. Radix sort, from the
  /// least significant digit on: a counting sort for each.
  template <class Key, class Value>
  void sort_pairs(const char* name, Span<Key> keys, Span<Value> values, int bits = int(sizeof(Key) * 8)) {
    static_assert(std::is_unsigned_v<Key>, "digits are taken by shifting");
    const StageTimer timer(times_, name);
    const int64_t n = keys.size();
    HostBuffer<Key> key_scratch;
    HostBuffer<Value> value_scratch;
    key_scratch.resize(n);
    value_scratch.resize(n);
    Span<Key> from = keys, to = key_scratch.span();
    Span<Value> from_values = values, to_values = value_scratch.span();
    for (int shift = 0; shift < bits; shift += kDigitBits) {
      const Key mask = (Key(1) << std::min(kDigitBits, bits - shift)) - 1;
      const auto digit = [=](int64_t i) { return static_cast<int>((from[i] >> shift) & mask); };
      sort(
          n, counters(n, int64_t(mask) + 1), [](int64_t, int64_t) {}, digit,
          [=](int64_t i, int position) {
            to[position] = from[i];
            to_values[position] = from_values[i];
          });
      std::swap(from, to);
      std::swap(from_values, to_values);
    }
    if (from.data() != keys.data()) {
      std::copy(from.begin(), from.end(), keys.data());
      std::copy(from_values.begin(), from_values.end(), values.data());
    }
  }

  /// Sorts value_of(0) … value_of(n−1) into bins, by a counting sort (n = values.size()): the values with key_of(i) = k
  /// are values[offsets[k]] … values[offsets[k + 1] − 1], in the order of i. Keys lie in 0 … offsets.size() − 2.
  template <class KeyOf, class ValueOf, class T>
  void bin(const char* name, const KeyOf& key_of, const ValueOf& value_of, Span<int> offsets, Span<T> values) {
    const StageTimer timer(times_, name);
    const int64_t n = values.size();
    keys_.resize(n);
    const Span<int> keys = keys_.span();
    offsets[0] = 0;
    const int64_t bins = offsets.size() - 1;
    const auto find_keys = [=](int64_t from, int64_t to) {
      const KeyOf key = key_of;  // a local copy, which no pointer can alias, as in run_range()
      for (int64_t i = from; i < to; ++i) keys[i] = key(static_cast<int>(i));
    };
    const auto put = [=](int64_t i, int position) { values[position] = value_of(static_cast<int>(i)); };
    const auto key = [=](int64_t i) { return keys[i]; };
    int* const ends = offsets.data() + 1;
    if (threads() == 1 || n + bins < kSortBlock) {
      sort(n, counters(n, bins, ends), find_keys, key, put);
    } else if (const KeyParts parts(RunBlocks{this}, n, keys.data(), bins, threads(), find_keys); parts.are_apart()) {
      parts.sort(RunBlocks{this}, ends, put);
    } else {
      sort(
          n, counters(n, bins, ends), [](int64_t, int64_t) {}, key, put);
    }
  }

  /// The same for the indices themselves, where bins hold few.
  template <class KeyOf>
  void bin_few(const char* name, const KeyOf& key_of, Span<int> offsets, Span<int> order) {
    bin(name, key_of, offsets, order);
  }

  /// Whatever bins hold.
  template <class KeyOf>
  void bin(const char* name, const KeyOf& key_of, Span<int> offsets, Span<int> order) {
    bin(
        name, key_of, [](int i) { return i; }, offsets, order);
  }

  /// Memory for n values that lasts until the next call with this index, 0 or 1.
  template <class T>
  Span<T> scratch(int index, int64_t n) {
    HostBuffer<std::max_align_t>& buffer = scratch_[index];
    const auto words =
        (n * int64_t(sizeof(T)) + int64_t(sizeof(std::max_align_t)) - 1) / int64_t(sizeof(std::max_align_t));
    buffer.resize(words);
    return {reinterpret_cast<T*>(buffer.span().data()), n};
  }

  template <class T>
  void upload(HostBuffer<T>& buffer, const T* values, int64_t n) {
    buffer.resize(n);
    std::copy(values, values + n, buffer.span().data());
  }
  template <class T>
  void upload(HostBuffer<T>& buffer, const std::vector<T>& values) {
    upload(buffer, values.data(), static_cast<int64_t>(values.size()));
  }

  template <class T>
  std::vector<std::remove_const_t<T>> download(Span<T> span) const {
    return {span.begin(), span.end()};
  }

 private:
  static constexpr int64_t kGrain = 512;  // indices; distributing smaller loops costs more than it gains
  static constexpr int64_t kScanBlock = 1 << 14;
  static constexpr int64_t kSortBlock = 1 << 15;
  static constexpr int kDigitBits = 11;

  /// Calls body(b) for each block b, in parallel.
  struct RunBlocks {
    CpuExecutor* exec;
    template <class Body>
    void operator()(int64_t blocks, const Body& body) const {
      exec->run(blocks, 1, body);
    }
  };

  /// For n indices: a block for each thread, unless there would be far more counters than indices. The last block counts
  /// in `last`, if it is given.
  BinCounters counters(int64_t n, int64_t bins, int* last = nullptr) {
    const int64_t limit = std::min(n / kSortBlock, 4 * n / std::max<int64_t>(bins, 1));
    const int64_t blocks = std::clamp<int64_t>(limit, 1, threads());
    counts_.resize((last ? blocks - 1 : blocks) * bins);
    BinCounters result{bins, {}};
    for (int64_t b = 0; b < blocks; ++b) result.blocks.push_back(counts_.span().data() + b * bins);
    if (last) result.blocks.back() = last;
    return result;
  }

  template <class FindKeys, class KeyOf, class Put>
  void sort(int64_t n, const BinCounters& counters, const FindKeys& find_keys, const KeyOf& key_of, const Put& put) {
    counting_sort(RunBlocks{this}, n, counters, find_keys, key_of, put);
  }

  template <class Kernel>
  void run(int64_t n, int64_t grain, const Kernel& kernel) {
    pool_.run_blocks(n, grain, {&run_range<Kernel>, &kernel});
  }

  /// Runs a local copy of the kernel, which no pointer can alias, with all calls inlined, so that its spans and scalars
  /// stay in registers. This saves about a seventh of a step. Not inlined itself, so that it is compiled once per
  /// kernel. A loop with a cast never becomes vector instructions; but those that cannot anyway are up to a fifth slower
  /// without it.
  template <class Kernel>
  [[gnu::flatten, gnu::noinline]] static void run_range(const void* shared, int64_t begin, int64_t end) {
    const Kernel kernel = *static_cast<const Kernel*>(shared);
    if constexpr (requires { Kernel::kIsElementwise; }) {
      const int last = static_cast<int>(end);
#pragma omp simd
      for (int i = static_cast<int>(begin); i < last; ++i) kernel(i);
    } else {
      for (int64_t i = begin; i != end; ++i) kernel(static_cast<int>(i));
    }
  }

  ThreadPool pool_;
  StageTimes times_;
  HostBuffer<int> keys_, counts_;  // of sorting, reused by each call
  HostBuffer<std::max_align_t> scratch_[2];
};

}  // namespace ballpit
