// SPDX-License-Identifier: MIT
// The exact reference: finds overlapping pairs by a sweep that shares no code with the methods it checks, and counts
// what a method got wrong. The other reference, in tests/support/oracle.h, tests all pairs and in turn checks this one.
//
//     sorted by one coordinate    a   b c    d  e …
//     a is tested against         b, c, d: all whose coordinate is within reach of a
//
// Cost: O(n log n + tests); O(n^(5/3)) tests for spheres that fill a cube evenly, at worst n(n−1)/2.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "world/pair_search.h"

namespace ballpit {

/// All pairs with |x_j − x_i|² ≤ (r_i + r_j)², evaluated in single precision: squared differences summed in the order
/// x, y, z; radii summed, then squared; with a period, differences to the nearest image. Sorted by i, then j. Calls
/// `tell` now and then with the number of spheres done.
std::vector<Pair> exact_pairs(const SphereArrays& spheres, const std::function<void(int64_t)>& tell = {});

/// How a list of pairs differs from the exact list.
struct Deviation {
  int64_t missed = 0;     ///< overlapping pairs that are not listed
  int64_t wrong = 0;      ///< entries that do not overlap, or whose i is not below j
  int64_t duplicate = 0;  ///< repeated entries
};

Deviation deviation_of(std::vector<Pair> found, const std::vector<Pair>& exact);

}  // namespace ballpit
