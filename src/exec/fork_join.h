// SPDX-License-Identifier: MIT
// Tells the thread sanitizer what oneTBB guarantees: all before a parallel loop happens before its body, and the body
// before all that follows. Debian's oneTBB is not instrumented, so the sanitizer cannot see its hand-overs itself.
// Without the sanitizer this compiles to nothing.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <atomic>
#endif

namespace ballpit {

class ForkJoin {
 public:
#ifdef __SANITIZE_THREAD__
  ForkJoin() { word_.store(0, std::memory_order_release); }
  void enter() { word_.load(std::memory_order_acquire); }
  void leave() { word_.fetch_add(1, std::memory_order_acq_rel); }
  void join() { word_.load(std::memory_order_acquire); }

 private:
  std::atomic<int> word_;
#else
  void enter() {}
  void leave() {}
  void join() {}
#endif
};

}  // namespace ballpit
