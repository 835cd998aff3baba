// SPDX-License-Identifier: MIT
// The past states of a world, for the window: goes one step forward or back, or to any step, with bit-identical states.
//
//     keyframes   0 ······ 16 ······ 32 ······ 48 ······ 64       every 16th step; if memory is short, every second one
//     recent                                    59 60 61 62 63    is dropped, so that every 32nd, 64th, … is left
//                                      ◂── go_to(61): restored
//                             ◂── go_to(35): 32 restored, then three steps
//
// States between two snapshots are computed again, bit-identical, so the memory is bounded however long the run is.
// Going back takes at most as many steps as keyframes are apart. If snapshots are small, the latest steps and those
// passed on the way back have one each, so that single steps back are instant. Measured times of a step, its snapshot
// and one step back: 3 000 spheres 1 ms, 0.02 ms, 0.02 ms; 100 000 spheres 17 ms, 0.8 ms, and 300 ms, then 0.5 ms.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "world/acts.h"

namespace ballpit {

class Timeline {
 public:
  static constexpr int64_t kBudget = int64_t(256) << 20;  // [bytes]

  /// Begins at the world's present state. The world must outlive the timeline, and only the timeline may step it. `dt`
  /// [s] is its step, `budget` [bytes] the limit of all snapshots; the first one is kept even if it is larger. Each step
  /// has its acts, if there are any; `acts` must outlive the timeline.
  Timeline(World& world, double dt, int64_t budget = kBudget, Acts* acts = nullptr);

  /// Called after each step, also of those that are computed again, but not where a state is restored.
  std::function<void()> after_step;

  /// One step forward. Throws RunError as World::step() does, and restores the world to the state before the step.
  /// Interrupted is thrown without restoring.
  void step();

  /// Goes to a step, or to the nearest one from first() to furthest(), with a bit-identical state. Calls stop() before
  /// each step that is computed again; if it returns true, go_to() returns false, and the next call goes on from there.
  bool go_to(int64_t step, const std::function<bool()>& stop = {});

  /// Acts on the world now. What was ahead is another motion then, and is forgotten. Throws as Acts::add() does.
  void act(const Act& act);

  int64_t step_now() const { return world_.steps(); }
  int64_t first() const { return first_; }
  int64_t furthest() const { return furthest_; }
  double time_of(int64_t step) const { return static_cast<double>(step) * dt_; }  ///< [s]

  int64_t bytes() const { return keyframes_.bytes + recent_.bytes; }  ///< of snapshots
  int64_t interval() const { return interval_; }                      ///< steps from one keyframe to the next

 private:
  /// Snapshots by their steps.
  struct Shelf {
    using Place = std::map<int64_t, std::unique_ptr<Snapshot>>::iterator;

    void put(int64_t step, std::unique_ptr<Snapshot> snapshot);
    Place drop(Place place);

    std::map<int64_t, std::unique_ptr<Snapshot>> at;
    int64_t bytes = 0;
  };

  void advance(bool keeps_recent);
  bool has_room_for(int64_t recent) const;
  void remember(bool keeps_recent);
  void forget_from(int64_t step);
  void thin_keyframes();
  void thin_recent();
  Shelf::Place latest_before(int64_t step);

  World& world_;
  Acts* acts_;
  double dt_;  // [s]
  int64_t budget_;
  int64_t first_, furthest_;
  int64_t interval_;
  int64_t largest_ = 0;  // snapshot so far [bytes]
  Shelf keyframes_, recent_;
};

/// Plays a world in time, with steps of constant length at any frame rate.
///
///     elapsed × speed ──▶ owed time ──▶ one step for each dt, until the frame's share of time is used; drop the rest
///
/// So a slow scene runs slower than the clock, and its delay does not grow.
class Player {
 public:
  bool is_running = true;
  double speed = 1;                  ///< simulated seconds a second
  std::function<void()> after_step;  ///< called after each step that the player makes; its time counts as a frame's

  /// Makes the steps that are due after `elapsed` [s], for at most `share` [s] but at least one. Returns the number of
  /// steps. A run that fails is paused, and failure() gives the reason.
  int advance(Timeline& timeline, double elapsed, double share);

  /// Pauses and makes one step.
  void step(Timeline& timeline);

  /// `elapsed` [s] of the clock have passed since the last call.
  void observe(double elapsed);

  /// Simulated seconds a second over the last half second; 0 while paused.
  double reached() const { return is_running ? reached_ : 0; }

  const std::string& failure() const { return failure_; }  ///< why the world cannot go on; empty if it can
  void forgive() { failure_.clear(); }                     ///< for a new world

  void forget_times() { step_times_.clear(); }  ///< for new settings

  /// Milliseconds of the latest steps, oldest first.
  const std::deque<float>& step_times() const { return step_times_; }
  double mean_step_time() const;  ///< [ms] of the latest steps

 private:
  bool try_step(Timeline& timeline);

  static constexpr size_t kKept = 240;
  double owed_ = 0;                     // [s]
  double sampled_ = 0, simulated_ = 0;  // [s] of the clock, and of the scene, since the last sample
  double reached_ = 0;
  std::string failure_;
  std::deque<float> step_times_;
};

}  // namespace ballpit
