// SPDX-License-Identifier: MIT
// Times steps of the gas for each method, backend and number of threads. All cases with one number of spheres are
// measured in turns (A B C A B C …), so that other load on the machine affects all equally. Each starts from the same
// moving gas.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "methods/settings.h"
#include "world/world.h"

namespace ballpit {

struct StepCase {
  std::string method;  ///< broad phase
  Backend backend;
  int threads = 0;  ///< of the CPU; 0 on other backends
};

/// A stage of one step, on average.
struct StepStage {
  std::string name;
  double seconds;
  double launches;
};

struct StepTiming {
  StepCase which;
  int64_t count = 0;            ///< spheres
  std::string skipped;          ///< why it was not measured; empty if it was
  std::vector<double> seconds;  ///< [s] per step: the mean of each block of steps
  int steps = 0;                ///< in a block
  int64_t contacts = 0;         ///< at the end
  int64_t candidates = 0;       ///< at the end
  std::vector<StepStage> stages;
};

struct TimingPlan {
  std::vector<StepCase> cases;
  std::vector<int64_t> counts;  ///< ascending
  int blocks = 5;               ///< measured for each case
  double limit = 5;             ///< [s] cases that need longer are skipped
  uint64_t seed = 1;            ///< of the gas
  Settings settings;            ///< those that the cases do not set
};

/// Measures every case at every count, smallest first. Cases predicted to exceed the limit, from their times with fewer
/// spheres, are skipped. Calls `tell` with the number of cases done. When `stop` returns true, returns what it has.
std::vector<StepTiming> time_steps(const TimingPlan& plan, const std::function<void(int64_t)>& tell,
                                   const std::function<bool()>& stop);

}  // namespace ballpit
