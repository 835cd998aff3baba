// SPDX-License-Identifier: MIT
// Times searches for pairs, from bare arrays to the list of pairs, in several ways on the same spheres: in turns
// (A B C A B C …), so that what else the machine does falls on all alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/lab.h"
#include "lab/sphere_set.h"
#include "lab/spread.h"
#include "simulate/settings.h"

namespace ballpit {

struct SearchTiming {
  std::vector<double> seconds;  ///< of a search; the mean over as many as take two milliseconds
  double candidates = 0;
  double contacts = 0;

  Spread spread() const { return spread_of(seconds); }
};

/// One timing for each of the ways, on the CPU. The first search of each warms up and is not counted. `key` names the
/// spheres and the ways.
std::vector<SearchTiming> time_searches(Lab& lab, const std::string& key, const std::vector<Settings>& ways,
                                        const std::function<SphereSet()>& make_spheres);

/// A broad phase by name on one thread, so that what is compared are methods, not how they share a busy machine; else as the
/// program has it.
Settings search_by(std::string_view broadphase);

/// Names of all broad phases but auto.
std::vector<std::string> broad_phases();

/// "linked cell", as labels of charts have it.
std::string label_of(std::string_view broadphase);

}  // namespace ballpit
