// SPDX-License-Identifier: MIT
// What share of the contacts a grid of small cells finds, by theory and by search.
//
//     c = 1      c = .5          Two centres are looked at together where their cells are neighbours: along each axis, cells
//    ┌───┬───┐  ┌─┬─┬─┬─┐        differ by one at most. At a distance d along it, d ≤ c, that is always so; beyond 2·c it
//    │ ● │ ● │  │●│ │ │●│        never is; between, a grid at a random place has them so in 2 − d/c of all cases.
//    └───┴───┘  └─┴─┴─┴─┘
#pragma once

#include <vector>

#include "bodies/pair.h"
#include "lab/measure/sphere_set.h"

namespace ballpit {

/// The mean over pairs of Π clamp(2 − |d_k|/edge, 0, 1) over the axes k: the expected share that a 3 × 3 × 3 block finds.
/// At least one pair.
double expected_recall(const SphereSet& spheres, const std::vector<Pair>& contacts, double edge);

/// The standard error of a share found among so many independent pairs.
double recall_error(double recall, size_t contacts);

}  // namespace ballpit
