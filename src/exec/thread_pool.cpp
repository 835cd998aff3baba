// SPDX-License-Identifier: MIT
#include "exec/thread_pool.h"

#include <algorithm>

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

#ifdef __SANITIZE_THREAD__

struct ThreadPool::Team {};

ThreadPool::ThreadPool(int threads)
    : threads_(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency())) {}

void ThreadPool::run_blocks_at_once(int64_t n, int64_t grain, LoopBody body) {
  std::vector<std::thread> team;
  for (int t = 0; t < threads_; ++t) {
    // Each thread has a fixed share, however late it starts: if one thread ran the whole loop, no race would show.
    team.emplace_back([this, t, n, grain, body] {
      for (int64_t begin = t * grain; begin < n; begin += threads_ * grain) body(begin, std::min(n, begin + grain));
    });
  }
  for (std::thread& thread : team) thread.join();
}

#else

struct ThreadPool::Team {
  // Lifts oneTBB's limit of one thread per core for the whole process. The arena sets our own limit.
  tbb::global_control allow_threads{tbb::global_control::max_allowed_parallelism, kMaxThreads};
  tbb::task_arena arena;
};

ThreadPool::ThreadPool(int threads)
    : team_(new Team{.arena = tbb::task_arena(threads > 0 ? threads : tbb::info::default_concurrency())}),
      threads_(team_->arena.max_concurrency()) {}

void ThreadPool::run_blocks_at_once(int64_t n, int64_t grain, LoopBody body) {
  team_->arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int64_t>(0, n, static_cast<size_t>(grain)),
                      [&](const auto& range) { body(range.begin(), range.end()); });
  });
}

#endif

ThreadPool::~ThreadPool() = default;

void ThreadPool::run_blocks(int64_t n, int64_t grain, LoopBody body) {
  if (n <= grain || threads_ == 1) {
    body(0, n);
  } else {
    run_blocks_at_once(n, grain, body);
  }
}

}  // namespace ballpit
