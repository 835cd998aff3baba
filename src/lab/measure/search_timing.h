// SPDX-License-Identifier: MIT
// Times searches for pairs, from bare arrays to the list of pairs, with several methods on the same spheres. They are
// measured in turns (A B C A B C …), so that other load on the machine affects all equally.
#pragma once

#include "lab/measure/lab.h"
#include "lab/measure/sphere_set.h"
#include "measure/statistics.h"
#include "methods/settings.h"

namespace ballpit {

struct SearchTiming {
  std::vector<double> seconds;  ///< of a search, each the mean over about two milliseconds
  double candidates = 0;

  Spread spread() const { return spread_of(seconds); }
};

/// Spheres, and the settings with which they are searched; `key` names both.
struct SearchCase {
  std::string key;
  std::vector<Settings> methods;
  std::function<SphereSet()> make_spheres;
};

inline constexpr int kSearchRounds = 3;  ///< of measurements of each case

/// For each case a timing of each of its methods, on the CPU. All cases are measured in rounds, so that a busy minute
/// of the machine does not affect one of them alone. The first searches of a round warm up and are not counted.
std::vector<std::vector<SearchTiming>> time_searches(Lab& lab, const std::vector<SearchCase>& cases);

/// A broad phase by name on one thread, which a busy machine disturbs least. All else has its default.
Settings search_by(std::string_view broadphase);

/// Names of all broad phases but auto.
const std::vector<std::string>& broad_phases();

/// "linked cell", for charts.
std::string label_of(std::string_view broadphase);

}  // namespace ballpit
