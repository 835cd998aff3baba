// SPDX-License-Identifier: MIT
#include "exec/thread_pool.h"

#include <chrono>
#include <mutex>
#include <set>
#include <thread>

#include <catch2/catch.hpp>

using namespace ballpit;

#ifndef __SANITIZE_THREAD__  // under which every loop is shared, so that races show
namespace {

/// A loop whose blocks take `pause` each, and the threads that ran some.
struct Watched {
  std::chrono::microseconds pause;
  std::mutex mutex = {};
  std::set<std::thread::id> threads = {};

  static void run_block(const void* data, int64_t, int64_t) {
    auto& watched = *static_cast<Watched*>(const_cast<void*>(data));
    std::this_thread::sleep_for(watched.pause);
    const std::lock_guard lock(watched.mutex);
    watched.threads.insert(std::this_thread::get_id());
  }
};

}  // namespace

TEST_CASE("a loop is shared by threads if its last run had work for them, and runs in the calling thread if not") {
  ThreadPool pool(4);
  const auto threads_of = [&pool](int microseconds) {
    Watched watched{std::chrono::microseconds(microseconds)};
    pool.run_blocks(40, 1, {&Watched::run_block, &watched});
    return watched.threads;
  };
  const std::set<std::thread::id> alone{std::this_thread::get_id()};
  CHECK(threads_of(2000).size() > 1);  // unknown yet
  // Another program may interrupt the run that shows how little work there is, which then seems long.
  bool was_alone = false;
  for (int k = 0; k < 20 && !was_alone; ++k) {
    threads_of(0);
    was_alone = threads_of(2000) == alone;
  }
  CHECK(was_alone);
  CHECK(threads_of(2000).size() > 1);
}
#endif
