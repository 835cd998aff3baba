// SPDX-License-Identifier: MIT
// Times searches for pairs, from bare arrays to the list of pairs, in several ways on the same spheres: in turns
// (A B C A B C …), so that what else the machine does falls on all alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/measure/lab.h"
#include "lab/measure/sphere_set.h"
#include "measure/spread.h"
#include "methods/settings.h"

namespace ballpit {

struct SearchTiming {
  std::vector<double> seconds;  ///< of a search; the mean over as many as take two milliseconds
  double candidates = 0;
  double contacts = 0;

  Spread spread() const { return spread_of(seconds); }
};

/// The same spheres, searched in several ways; `key` names both.
struct SearchCase {
  std::string key;
  std::vector<Settings> ways;
  std::function<SphereSet()> make_spheres;
};

inline constexpr int kSearchRounds = 3;  ///< measurements of a case

/// For each case a timing for each of its ways, on the CPU. All cases are measured in rounds, so that a busy minute of the machine
/// does not fall on one of them alone. The first searches of a round warm up and are not counted.
std::vector<std::vector<SearchTiming>> time_searches(Lab& lab, const std::vector<SearchCase>& cases);

/// A broad phase by name on one thread, so that what is compared are methods, not how they share a busy machine; else as the
/// program has it.
Settings search_by(std::string_view broadphase);

/// Names of all broad phases but auto.
std::vector<std::string> broad_phases();

/// "linked cell", as labels of charts have it.
std::string label_of(std::string_view broadphase);

}  // namespace ballpit
