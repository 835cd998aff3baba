// SPDX-License-Identifier: MIT
// What every search must find: the pairs, by linked cells in double precision, which is exact on these spheres. Shares
// no code with what it judges.
// Cost: O(n) for spheres of like size; memory for at most about as many cells as spheres.
#pragma once

#include <cstdint>
#include <vector>

#include "bodies/pair.h"
#include "families.h"

namespace ballpit {

/// All overlapping pairs, i < j, sorted by i, then j.
std::vector<Pair> reference_pairs(const Spheres& spheres);

/// A set of pairs in two numbers, which know neither order nor direction.
struct PairSet {
  int64_t count = 0;
  uint64_t hash = 0;
  friend bool operator==(const PairSet&, const PairSet&) = default;
};

PairSet pair_set(const std::vector<Pair>& pairs);

}  // namespace ballpit
