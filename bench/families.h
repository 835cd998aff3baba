// SPDX-License-Identifier: MIT
// Seven families of spheres for broad phases: loose and dense, equal and unequal, in space, on a plane and in a column.
// Benchmarks time searches on them, and tests compare sets of pairs.
//
// Rounding never decides whether two spheres touch: coordinates and radii are multiples of a power of two so coarse
// that x ± r and all differences are exact in float, and no pair is within 4·10⁻⁶ of touching. So float, double and
// fused arithmetic agree on the set of pairs, on every platform. Cost: O(n), mostly for the search for pairs that
// nearly touch: a second or two for a million spheres.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/math.h"

namespace ballpit {

/// Lengths are in diameters of the equal spheres.
struct Spheres {
  std::vector<Vec3> position;
  std::vector<float> radius;  ///< one for all, or one for each

  int64_t count() const { return static_cast<int64_t>(position.size()); }
  float radius_of(int64_t i) const { return radius[radius.size() == 1 ? 0 : static_cast<size_t>(i)]; }
};

struct FamilyInfo {
  std::string_view name;
  std::string_view description;
};

std::span<const FamilyInfo> families();

/// `count` spheres of a family, in shuffled order. Throws UserError for an unknown name or a count below 1.
Spheres make_family(std::string_view name, int64_t count, uint64_t seed);

/// `start` after `steps` steps of a steady drift: each sphere moves by 1 % of its radius per step in its own direction,
/// drawn from `seed`. Spheres whose centres are on a plane of equal z stay on it.
Spheres drifted(const Spheres& start, int64_t steps, uint64_t seed);

}  // namespace ballpit
