// SPDX-License-Identifier: MIT
#include "exec/thread_pool.h"

#include <algorithm>

#ifdef __SANITIZE_THREAD__
#include <thread>
#include <vector>
#else
#include <atomic>
#include <chrono>
#include <limits>
#include <unordered_map>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace ballpit {

#ifdef __SANITIZE_THREAD__

struct ThreadPool::Team {};  // every loop of several blocks is shared, or races would not show

ThreadPool::ThreadPool(int threads)
    : threads_(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency())) {}

void ThreadPool::share_blocks(int64_t n, int64_t grain, LoopBody body) {
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

namespace {

using Clock = std::chrono::steady_clock;

// A loop with less work than this is done before other threads have woken. On two cores of a virtual machine 20 µs left
// steps of 5 000 spheres slower on two threads than on one, and 100 µs gave away a tenth of those of 100 000.
constexpr double kWorthSharing = Clock::duration(std::chrono::microseconds(50)).count();  // [ticks of Clock]

}  // namespace

struct ThreadPool::Team {
  // Lifts oneTBB's limit of one thread per core for the whole process. The arena sets our own limit.
  tbb::global_control allow_threads{tbb::global_control::max_allowed_parallelism, kMaxThreads};
  tbb::task_arena arena;
};

ThreadPool::ThreadPool(int threads)
    : team_(new Team{.arena = tbb::task_arena(threads > 0 ? threads : tbb::info::default_concurrency())}),
      threads_(team_->arena.max_concurrency()) {}

void ThreadPool::share_blocks(int64_t n, int64_t grain, LoopBody body) {
  // Time for an index [ticks of Clock], by the function of a loop, as in its last run.
  thread_local std::unordered_map<decltype(LoopBody::run_block), double> costs;
  double& cost = costs.try_emplace(body.run_block, std::numeric_limits<double>::infinity()).first->second;
  std::atomic<Clock::rep> work = 0;
  const auto run_timed = [&](int64_t begin, int64_t end) {
    const Clock::time_point start = Clock::now();
    body(begin, end);
    work.fetch_add((Clock::now() - start).count(), std::memory_order_relaxed);
  };
  if (cost * static_cast<double>(n) < kWorthSharing) {
    run_timed(0, n);
  } else {
    team_->arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<int64_t>(0, n, static_cast<size_t>(grain)),
                        [&](const auto& range) { run_timed(range.begin(), range.end()); });
    });
  }
  cost = static_cast<double>(work) / static_cast<double>(n);
}

#endif

ThreadPool::~ThreadPool() = default;

void ThreadPool::run_blocks(int64_t n, int64_t grain, LoopBody body) {
  if (n <= grain || threads_ == 1) {
    body(0, n);
  } else {
    share_blocks(n, grain, body);
  }
}

}  // namespace ballpit
