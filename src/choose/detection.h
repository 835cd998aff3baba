// SPDX-License-Identifier: MIT
// Chooses how contacts are found, by timing steps from a state in the middle of a run. It changes no bit of the motion.
#pragma once

#include "choose/pilot.h"

namespace ballpit {

struct CheapestSearch {
  Settings settings;
  double ratio;  ///< time of a step, by that before
};

/// The settings with the cheapest broad phase, skin, number of threads and processor, but for those that are given.
/// `count` is the number of spheres that the choice is for; `scene` may be a part. Takes about `seconds` [s].
CheapestSearch with_cheapest_search(const Scene& scene, const Needs& needs, const Settings& settings,
                                    const std::vector<GivenOption>& given, int64_t count, double seconds);

/// [s] of a step from the state of the scene: the least of three blocks, each of at least `block` [s]. Infinite for a run
/// that is stopped.
double time_of_step(const Scene& scene, const Needs& needs, const Settings& settings, double block);

/// One thread, or all: whichever makes the first steps sooner. As it is if threads are given.
int cheapest_threads(const Scene& scene, const Needs& needs, const Settings& settings,
                     const std::vector<GivenOption>& given);

}  // namespace ballpit
