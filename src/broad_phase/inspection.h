// SPDX-License-Identifier: MIT
// Copies of a broad phase's data structures on the host, for overlays.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/math.h"

namespace ballpit {

/// How a method stores the bodies of its cells: in linked cell lists (head and next), or sorted by cell. A hashed grid
/// has an entry for each bucket, which cells share, instead of one for each cell.
struct CellArrays {
  bool is_sorted = false;
  bool is_hashed = false;
  std::vector<int32_t> cells;   ///< head; if sorted, where each entry's range begins, and at last where all end
  std::vector<int32_t> bodies;  ///< next; if sorted, the bodies of all ranges
};

/// A grid of cells for the audience. Cell (x, y, z) has the index (z · cells.y + y) · cells.x + x and covers origin +
/// (x, y, z) ∘ edge to origin + (x+1, y+1, z+1) ∘ edge. Its cell list starts at head[index] and continues along next[],
/// however the method stores its cells. In a sorted grid the last body of the range comes first.
struct GridInspection {
  Vec3 origin{0.0f};
  Vec3 edge{0.0f};  ///< [m] equal along all axes, unless a periodic domain stretches it to a whole number of cells
  IVec3 cells{0};   ///< z is 1 in planar scenes
  std::vector<int32_t> head;         ///< one entry per cell: its first body, or −1; empty if there are too many cells
  std::vector<int32_t> next;         ///< one entry per body: the one linked before it, or −1
  std::optional<CellArrays> arrays;  ///< the method's own arrays; none if they are head and next

  bool is_sorted() const { return arrays && arrays->is_sorted; }
};

/// An entry of sort-and-sweep's sorted list: where a sphere begins or ends along the axis, up to a guard against
/// rounding of about a millionth.
struct Endpoint {
  float at = 0;  ///< [m]
  int32_t body = 0;
  bool is_end = false;
};

}  // namespace ballpit
