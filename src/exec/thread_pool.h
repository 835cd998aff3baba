// SPDX-License-Identifier: MIT
// ThreadPool: distributes the blocks of a loop among threads. Uses oneTBB, except under the thread sanitizer: Debian's
// oneTBB is not compiled with it, so the sanitizer would miss how threads wait for each other and report every loop.
// With the sanitizer, each loop starts plain threads: slow, but every race that it then reports is in one of our
// kernels.
//
// A loop's body is passed as a pointer to a function, so that oneTBB's templates are compiled once, in thread_pool.cpp,
// and not again for each kernel.
#pragma once

#include <cstdint>
#include <memory>

namespace ballpit {

inline constexpr int kMaxThreads = 256;

/// A loop's body: a function that runs a block of indices, and its data.
struct LoopBody {
  void (*run_block)(const void* data, int64_t begin, int64_t end);
  const void* data;

  void operator()(int64_t begin, int64_t end) const { run_block(data, begin, end); }
};

class ThreadPool {
 public:
  /// `threads` may exceed the number of cores; 0 means all cores.
  explicit ThreadPool(int threads);
  ~ThreadPool();

  int threads() const { return threads_; }

  /// Divides 0 … n−1 into blocks of at least `grain` indices (the last may be smaller), calls body(begin, end) for them
  /// in parallel, and waits for all. A loop of one block, on one thread, or with so little work in its last run that
  /// waking other threads takes longer, runs in the calling thread.
  void run_blocks(int64_t n, int64_t grain, LoopBody body);

 private:
  struct Team;

  void share_blocks(int64_t n, int64_t grain, LoopBody body);

  std::unique_ptr<Team> team_;
  int threads_;
};

}  // namespace ballpit
