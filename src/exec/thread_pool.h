// SPDX-License-Identifier: MIT
// ThreadPool: hands the blocks of a loop out to threads. By oneTBB, except under the thread sanitizer: Debian's oneTBB is
// not compiled with it, so the sanitizer sees neither its hand-overs nor their order and reports every loop. There, the
// blocks go to plain threads, made for each loop: slow, but every race that it then reports is one of our kernels.
//
// The loop's body is passed as a pointer to a function, so that oneTBB's templates are compiled once, in thread_pool.cpp,
// and not again for each kernel. A block has hundreds of indices or more: the indirect call costs nothing beside it.
#pragma once

#include <cstdint>
#include <memory>

namespace ballpit {

inline constexpr int kMaxThreads = 256;

/// A reference to any callable as body(begin, end). It must not outlive the callable.
class BlockBody {
 public:
  template <class Body>
  explicit BlockBody(const Body& body)
      : body_(&body),
        call_([](const void* at, int64_t begin, int64_t end) { (*static_cast<const Body*>(at))(begin, end); }) {}

  void operator()(int64_t begin, int64_t end) const { call_(body_, begin, end); }

 private:
  const void* body_;
  void (*call_)(const void* body, int64_t begin, int64_t end);
};

class ThreadPool {
 public:
  /// `threads` may exceed the number of cores; 0 means all cores.
  explicit ThreadPool(int threads);
  ~ThreadPool();

  int threads() const { return threads_; }

  /// Calls body(begin, end) for blocks of at least `grain` (but the last) that make up 0 … n−1, at once; waits for all.
  void run_blocks(int64_t n, int64_t grain, BlockBody body);

 private:
  struct Team;

  std::unique_ptr<Team> team_;
  int threads_;
};

}  // namespace ballpit
