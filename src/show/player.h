// SPDX-License-Identifier: MIT
// Plays a world in time: fixed steps, as many as the clock asks for, whatever the rate of frames.
//
//     elapsed × speed ──▶ owed ──▶ one step for each dt, until the frame's share of time is used up; the rest is dropped
//
// So a slow scene runs slower than the clock, and never falls behind itself further and further.
#pragma once

#include <deque>
#include <string>

#include "show/timeline.h"

namespace ballpit {

class Player {
 public:
  bool is_running = true;
  double speed = 1;  ///< simulated seconds a second

  /// Steps as time goes on by `elapsed` [s], for `share` [s] at most; at least once where a step is owed. Returns the steps
  /// made. A run that cannot go on is paused, and says why in failure().
  int advance(Timeline& timeline, double elapsed, double share);

  /// One step; pauses.
  void step(Timeline& timeline);

  const std::string& failure() const { return failure_; }  ///< why the world cannot go on; empty where it can
  void forgive() { failure_.clear(); }                     ///< the world is another one now

  void forget_times() { step_times_.clear(); }  ///< what steps cost is another now

  /// Milliseconds of the latest steps, oldest first.
  const std::deque<float>& step_times() const { return step_times_; }
  double mean_step_time() const;  ///< [ms] of the latest steps

 private:
  bool try_step(Timeline& timeline);

  static constexpr size_t kKept = 240;
  double owed_ = 0;  // [s]
  std::string failure_;
  std::deque<float> step_times_;
};

}  // namespace ballpit
