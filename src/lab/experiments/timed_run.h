// SPDX-License-Identifier: MIT
// A world on the CPU whose steps are timed. Its failure is a result, not an error.
#pragma once

#include <algorithm>
#include <chrono>
#include <memory>

#include "core/error.h"
#include "lab/measure/made_scenes.h"

namespace ballpit {

class TimedRun {
 public:
  TimedRun(const Scene& scene, const Settings& settings) : world_(make_cpu_world(scene, settings)), dt_(settings.dt) {}

  /// Steps until `time` [s]; false if the run stops before.
  bool reach(double time) {
    const auto start = std::chrono::steady_clock::now();
    try {
      if (!has_stopped_) step_until(*world_, time, dt_);
    } catch (const RunError&) {
      has_stopped_ = true;
    }
    spent_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return !has_stopped_;
  }

  /// Computation time [s] per simulated second.
  double seconds() const { return spent_ / std::max(world_->time(), dt_); }

  double spent() const { return spent_; }  ///< computation time [s]

  World& world() { return *world_; }

 private:
  std::unique_ptr<World> world_;
  double dt_;
  double spent_ = 0;
  bool has_stopped_ = false;
};

}  // namespace ballpit
