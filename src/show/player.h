// SPDX-License-Identifier: MIT
// Plays a world in time, with steps of constant length at any frame rate.
//
//     elapsed × speed ──▶ owed time ──▶ one step for each dt, until the frame's share of time is used; the rest is dropped
//
// So a slow scene runs slower than the clock, and its delay does not grow.
#pragma once

#include <deque>
#include <string>

#include "show/timeline.h"

namespace ballpit {

class Player {
 public:
  bool is_running = true;
  double speed = 1;  ///< simulated seconds a second

  /// Makes the steps that are due after `elapsed` [s], for at most `share` [s] but at least one. Returns the number of
  /// steps. A run that fails is paused, and failure() gives the reason.
  int advance(Timeline& timeline, double elapsed, double share);

  /// Pauses and makes one step.
  void step(Timeline& timeline);

  const std::string& failure() const { return failure_; }  ///< why the world cannot go on; empty if it can
  void forgive() { failure_.clear(); }                     ///< for a new world

  void forget_times() { step_times_.clear(); }  ///< for new settings

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
