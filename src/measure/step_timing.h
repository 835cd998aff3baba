// SPDX-License-Identifier: MIT
// Times steps of the gas by method, backend and threads. All cases of one number of spheres are measured in turns
// (A B C A B C …), so that what else the machine does falls on all alike; each starts from the same gas in motion.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "methods/settings.h"
#include "world/world.h"

namespace ballpit {

/// Who steps the gas.
struct StepCase {
  std::string method;  ///< broad phase
  Backend backend;
  int threads = 0;  ///< of the CPU; 0 where it does not step
};

/// A stage in one step, on average.
struct StepStage {
  std::string name;
  double seconds;
  double launches;
};

struct StepTiming {
  StepCase which;
  int64_t count = 0;            ///< spheres
  std::string skipped;          ///< why it was not measured; empty where it was
  std::vector<double> seconds;  ///< [s] a step: the mean of each block of steps
  int steps = 0;                ///< in a block
  int64_t contacts = 0;         ///< at the end
  int64_t candidates = 0;       ///< at the end
  std::vector<StepStage> stages;
};

struct TimingPlan {
  std::vector<StepCase> cases;
  std::vector<int64_t> counts;  ///< ascending
  int blocks = 5;               ///< measured of each case
  double limit = 5;             ///< [s] a case that needs longer is skipped
  uint64_t seed = 1;            ///< of the gas
  Settings settings;            ///< but for those that the cases set
};

/// Measures every case at every count, smallest first; one that will need longer than the limit, by what it took for
/// fewer spheres, is skipped. `tell` hears how many are done; where `stop` is true, it ends with what it has.
std::vector<StepTiming> time_steps(const TimingPlan& plan, const std::function<void(int64_t)>& tell,
                                   const std::function<bool()>& stop);

}  // namespace ballpit
