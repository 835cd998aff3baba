// SPDX-License-Identifier: MIT
// Watches a run of --response auto: looks at overlap, energy and the fastest sphere now and then, and says when they
// break what the scene needs. The run then goes back to the last good snapshot and on with dearer settings.
//
//     snapshot ── 128 steps ── look ── good: snapshot ── 128 steps ── look ── broken: restore, next settings
//
// Cost: a look and a snapshot take less than a step and come every kSteps steps.
#pragma once

#include <deque>
#include <memory>

#include "choose/choose.h"

namespace ballpit {

class Watch {
 public:
  static constexpr int64_t kSteps = 128;  ///< between two looks

  /// At the start of a run. `choice` has settings.
  Watch(const Scene& scene, const Choice& choice, World& world);

  /// Whether it is time to look; a run also looks where others will see its state.
  bool is_due(const World& world) const { return world.steps() - good_steps_ >= kSteps; }

  /// What is broken now; empty if nothing is. At the end of the needs' duration all tolerances count.
  std::string breach(World& world, const Settings& settings) const;

  /// Keeps the present state as the last good one.
  void accept(World& world);

  /// Goes back to the last good state.
  void go_back(World& world) const;

  /// The next dearer settings; empty if there are none.
  std::optional<Settings> next();

 private:
  bool is_end(const World& world) const;

  Domain domain_;
  Needs needs_;
  std::vector<Tolerance> tolerances_;
  NeedsMeter meter_;
  double allowed_overlap_;  // during the run, as a fraction of the smaller radius
  SceneNumbers numbers_;
  std::deque<Settings> dearer_;
  std::unique_ptr<Snapshot> good_;
  int64_t good_steps_ = 0;
};

}  // namespace ballpit
