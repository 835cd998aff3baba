// SPDX-License-Identifier: MIT
// Times by stage: every launch of an executor has a name, and timings, panel and profilers show the same names.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace ballpit {

struct Stage {
  std::string name;    ///< "link bodies"
  double seconds = 0;  ///< of all launches together
  int64_t launches = 0;
};

/// Stages in the order of their first launch.
class StageTimes {
 public:
  void add(const char* name, double seconds) {
    auto stage = std::ranges::find(stages_, name, &Stage::name);
    if (stage == stages_.end()) stage = stages_.insert(stage, Stage{name});
    stage->seconds += seconds;
    ++stage->launches;
  }
  const std::vector<Stage>& stages() const { return stages_; }
  void clear() { stages_.clear(); }

 private:
  std::vector<Stage> stages_;
};

/// Adds the time from its construction to its destruction [s].
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Adds the time from its construction to its destruction to a stage.
class StageTimer {
 public:
  StageTimer(StageTimes& times, const char* name) : times_(times), name_(name) {}
  ~StageTimer() { times_.add(name_, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count()); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  StageTimes& times_;
  const char* name_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ballpit
