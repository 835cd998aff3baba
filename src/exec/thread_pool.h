// SPDX-License-Identifier: MIT
// ThreadPool: hands the blocks of a loop out to threads. By oneTBB, except under the thread sanitizer: Debian's oneTBB is
// not compiled with it, so the sanitizer sees neither its hand-overs nor their order and reports every loop. There, the
// blocks go to plain threads, made for each loop: slow, but every race that it then reports is one of our kernels.
#pragma once

#include <algorithm>
#include <cstdint>

#ifdef __SANITIZE_THREAD__
#include <thread>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace ballpit {

inline constexpr int kMaxThreads = 256;

#ifdef __SANITIZE_THREAD__

class ThreadPool {
 public:
  explicit ThreadPool(int threads)
      : threads_(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency())) {}

  int threads() const { return threads_; }

  template <class Body>
  void run_blocks(int64_t n, int64_t grain, const Body& body) {
    std::vector<std::thread> team;
    for (int t = 0; t < threads_; ++t) {
      // Every thread gets its share, however late it starts: a loop that one thread did alone would show no race.
      team.emplace_back([this, t, n, grain, &body] {
        for (int64_t begin = t * grain; begin < n; begin += threads_ * grain) body(begin, std::min(n, begin + grain));
      });
    }
    for (std::thread& thread : team) thread.join();
  }

 private:
  int threads_;
};

#else

class ThreadPool {
 public:
  /// `threads` may exceed the number of cores; 0 means all cores.
  explicit ThreadPool(int threads) : arena_(threads > 0 ? threads : tbb::info::default_concurrency()) {}

  int threads() const { return arena_.max_concurrency(); }

  /// Calls body(begin, end) for blocks of at least `grain` (but the last) that make up 0 … n−1, at once; waits for all.
  template <class Body>
  void run_blocks(int64_t n, int64_t grain, const Body& body) {
    arena_.execute([&] {
      tbb::parallel_for(tbb::blocked_range<int64_t>(0, n, static_cast<size_t>(grain)),
                        [&](const auto& range) { body(range.begin(), range.end()); });
    });
  }

 private:
  // Lifts oneTBB's limit of one thread per core, which holds for the whole process; the arena sets ours.
  tbb::global_control allow_threads_{tbb::global_control::max_allowed_parallelism, kMaxThreads};
  tbb::task_arena arena_;
};

#endif

}  // namespace ballpit
