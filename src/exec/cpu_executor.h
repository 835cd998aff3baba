// SPDX-License-Identifier: MIT
// The execution contract, and its implementation on all cores by oneTBB.
//
// A method is a template over its executor and calls
//     exec.parallel_for("link bodies", n, LinkBody{…})      kernel(i) for each i in 0 … n−1, in any order, at once
//     exec.fill("clear cells", span, −1)                    every element set
//     exec.exclusive_scan("offsets", counts, offsets)       offsets[i] = counts[0] + … + counts[i−1]; returns the total
//     exec.sort_pairs("sort endpoints", keys, values)       stable, by key
//     exec.upload(buffer, host) / exec.download(span)       copies from and to the host
// and reduce() of exec/reduce.h. Results do not depend on the number of threads. Every launch is timed under its name.
// Its sibling is CudaExecutor in cuda/.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/span.h"
#include "exec/host_buffer.h"
#include "exec/stage_times.h"
#include "exec/thread_pool.h"

namespace ballpit {

class CpuExecutor {
 public:
  template <class T>
  using Buffer = HostBuffer<T>;

  /// Runs on `threads` threads, also more than there are cores; 0 means all cores.
  explicit CpuExecutor(int threads) : pool_(threads) {}

  int threads() const { return pool_.threads(); }
  StageTimes& stage_times() { return times_; }

  /// Calls kernel(i) for each i in 0 … n−1. Kernels that touch the same element must do so by exec/atomics.h.
  template <class Kernel>
  void parallel_for(const char* name, int64_t n, const Kernel& kernel) {
    const StageTimer timer(times_, name);
    run(n, kGrain, kernel);
  }

  template <class T>
  void fill(const char* name, Span<T> span, T value) {
    parallel_for(name, span.size(), [span, value](int i) { span[i] = value; });
  }

  /// offsets[i] = counts[0] + … + counts[i−1] for i in 0 … n, so offsets has one element more than counts. Returns the
  /// total in 64 bits: where it exceeds what an int holds, the offsets are void and the caller must say so.
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

  /// Sorts values by their keys; values of equal keys keep their order. Merge sort: runs sorted at once, then merged
  /// in pairs.
  template <class Key, class Value>
  void sort_pairs(const char* name, Span<Key> keys, Span<Value> values) {
    const StageTimer timer(times_, name);
    struct Entry {
      Key key;
      Value value;
      bool operator<(const Entry& other) const { return key < other.key; }
    };
    const int64_t n = keys.size();
    std::vector<Entry> from(static_cast<size_t>(n)), to(from.size());
    run(n, kGrain, [&](int i) { from[static_cast<size_t>(i)] = {keys[i], values[i]}; });
    const auto at = [n](int64_t i) { return static_cast<std::ptrdiff_t>(std::min(i, n)); };
    run((n + kSortRun - 1) / kSortRun, 1,
        [&](int r) { std::stable_sort(from.begin() + at(r * kSortRun), from.begin() + at((r + 1) * kSortRun)); });
    for (int64_t width = kSortRun; width < n; width *= 2) {
      run((n + 2 * width - 1) / (2 * width), 1, [&](int m) {
        const auto low = from.begin() + at(2 * m * width), mid = from.begin() + at((2 * m + 1) * width);
        std::merge(low, mid, mid, from.begin() + at((2 * m + 2) * width), to.begin() + at(2 * m * width));
      });
      std::swap(from, to);
    }
    run(n, kGrain, [&](int i) {
      keys[i] = from[static_cast<size_t>(i)].key;
      values[i] = from[static_cast<size_t>(i)].value;
    });
  }

  template <class T>
  void upload(HostBuffer<T>& buffer, const std::vector<T>& values) {
    buffer.resize(static_cast<int64_t>(values.size()));
    std::copy(values.begin(), values.end(), buffer.span().data());
  }

  template <class T>
  std::vector<std::remove_const_t<T>> download(Span<T> span) const {
    return {span.begin(), span.end()};
  }

 private:
  static constexpr int64_t kGrain = 512;  // smaller loops cost less on one thread than the handing out
  static constexpr int64_t kScanBlock = 1 << 14;
  static constexpr int64_t kSortRun = 1 << 13;

  template <class Kernel>
  void run(int64_t n, int64_t grain, const Kernel& kernel) {
    if (n <= grain || pool_.threads() == 1) {
      run_range(0, n, kernel);
    } else {
      pool_.run_blocks(n, grain, [&](int64_t begin, int64_t end) { run_range(begin, end, kernel); });
    }
  }

  /// A copy of the kernel that nothing else can point to, and all calls inlined: its spans and scalars then stay in
  /// registers. Measured: about a seventh off the step.
  template <class Kernel>
  [[gnu::flatten]] static void run_range(int64_t begin, int64_t end, const Kernel& shared) {
    const Kernel kernel = shared;
    for (int64_t i = begin; i != end; ++i) kernel(static_cast<int>(i));
  }

  ThreadPool pool_;
  StageTimes times_;
};

}  // namespace ballpit
