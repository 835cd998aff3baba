// SPDX-License-Identifier: MIT
// The gas of `ballpit bench`, and times of its steps for each method, backend and number of threads. All cases with one
// number of spheres are measured in turns (A B C A B C …), so that other load on the machine affects all equally. Each
// starts from the same moving gas.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "methods/settings.h"
#include "world/world.h"

namespace ballpit {

inline constexpr double kGasVolumeFraction = 0.3;  ///< of the box
inline constexpr double kGasStep = 1.0 / 960;      ///< [s] in which a sphere moves a tenth of its radius at most
inline constexpr int kGasStepsToEquilibrium = 20;  ///< after which the number of contacts stays constant

/// A gas of equal elastic spheres, whose density is the same for any number: `count` spheres of 1 cm radius and up to
/// 1 m/s in a cube, on a cubic lattice, each displaced at random without touching another, in shuffled order. Equal
/// seeds give equal scenes.
Scene make_gas(int64_t count, uint64_t seed = 1);

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
