// SPDX-License-Identifier: MIT
// Times searches for pairs, from bare arrays to the list of pairs, with several methods on the same spheres at rest.
// They are measured in turns (A B C A B C …), so that other load on the machine affects all equally.
#pragma once

#include "lab/measure/lab.h"
#include "measure/statistics.h"
#include "methods/settings.h"
#include "world/pair_search.h"

namespace ballpit {

/// Lengths are in diameters of the largest sphere.
struct SphereSet {
  std::vector<Vec3> position;
  std::vector<float> radius;  ///< one for all, or one for each

  SphereArrays arrays() const {
    return {{position.data(), static_cast<int64_t>(position.size())},
            {radius.data(), static_cast<int64_t>(radius.size())}};
  }
};

struct UniformSpheres {
  int64_t count = 0;
  double volume_fraction = 0.3;  ///< of the box, overlaps counted twice
  double size_ratio = 1;         ///< of the largest radius to the smallest; between, the density of radii is ~ r⁻³
  double aspect = 1;             ///< the box's height (z) over its width
};

/// Centres uniform in a box.
SphereSet uniform_spheres(const UniformSpheres& wanted, uint64_t seed);

/// The box of uniform_spheres() [diameters].
Vec3d box_of(const UniformSpheres& wanted);

/// `count` spheres (an even number) in pairs that just touch, each in a random direction. Pairs do not touch each
/// other: each has a random place in its own cell of a wide lattice.
SphereSet touching_pairs(int64_t count, uint64_t seed);

/// Equal spheres in Gaussian clouds of about a thousand with a standard deviation of 3.5 diameters.
SphereSet clouds(int64_t count, uint64_t seed);

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
