// SPDX-License-Identifier: MIT
// What an inspection says of one sphere: the list that it is in, its interval, its candidates.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/inspection.h"

namespace ballpit {

/// A cell and its list, as a grid has them.
struct ListedIn {
  IVec3 cell{0};
  int index = 0;                ///< of the cell: head[index]
  bool is_sorted = false;       ///< a range of bodies sorted by cell; else a linked list
  std::vector<int32_t> bodies;  ///< of the list, from head on, or of the range
  size_t place = 0;             ///< of the sphere among them
};

/// Of the grid that lists the body; none where no grid does.
std::optional<ListedIn> listed_in(const Inspection& inspection, int32_t body);

/// Where a sphere begins and ends along the axis of the sweep.
struct Interval {
  float begin = 0, end = 0;               ///< [m]
  size_t begin_place = 0, end_place = 0;  ///< in the sorted list
};

/// None where nothing was swept.
std::optional<Interval> interval_of(const Inspection& inspection, int32_t body);

/// The other sphere of each pair that the body is in, in their order.
std::vector<int32_t> partners_of(const std::vector<Pair>& pairs, int32_t body);

}  // namespace ballpit
