// SPDX-License-Identifier: MIT
// The exact reference: overlapping pairs found by a sweep that shares no code with the methods it checks, and what a
// method got wrong against it.
//
//     sorted by one coordinate    a   b c    d  e …
//     a is tested against         b, c, d: all that begin before nothing can reach a any more
//
// Cost: O(n log n + tests); the tests are O(n^(5/3)) for spheres that fill a cube evenly, at worst n(n−1)/2.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "world/pair_search.h"

namespace ballpit {

/// All pairs with |x_j − x_i|² ≤ (r_i + r_j)², as single precision evaluates it: differences, their squares summed in
/// the order x, y, z; radii summed, then squared; with a period, differences to the nearest image. Sorted by i, then j.
/// `tell` hears now and then how many spheres are done.
std::vector<Pair> exact_pairs(const SphereArrays& spheres, const std::function<void(int64_t)>& tell = {});

/// How a list of pairs differs from the exact one.
struct Deviation {
  int64_t missed = 0;     ///< pairs that overlap and are not listed
  int64_t wrong = 0;      ///< entries that do not overlap, or are no pair i < j
  int64_t duplicate = 0;  ///< entries that were listed before
};

Deviation deviation_of(std::vector<Pair> found, const std::vector<Pair>& exact);

}  // namespace ballpit
