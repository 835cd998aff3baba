// SPDX-License-Identifier: MIT
// Finds one sphere in an inspection: the list that it is in, its interval, its candidates.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/inspection.h"

namespace ballpit {

/// A cell of a grid and its list.
struct ListedIn {
  IVec3 cell{0};
  int index = 0;                ///< of the cell: head[index]
  bool is_sorted = false;       ///< a range of bodies sorted by cell, not a linked list
  std::vector<int32_t> bodies;  ///< of the list, from its head on, or of the range
  size_t place = 0;             ///< index of the sphere in `bodies`
};

/// Empty if no grid lists the body.
std::optional<ListedIn> listed_in(const Inspection& inspection, int32_t body);

/// Where a sphere begins and ends along the axis of the sweep.
struct Interval {
  float begin = 0, end = 0;               ///< [m]
  size_t begin_place = 0, end_place = 0;  ///< in the sorted list
};

/// Empty if nothing was swept.
std::optional<Interval> interval_of(const Inspection& inspection, int32_t body);

/// The other spheres of the pairs that contain the body, ascending.
std::vector<int32_t> partners_of(const std::vector<Pair>& pairs, int32_t body);

}  // namespace ballpit
