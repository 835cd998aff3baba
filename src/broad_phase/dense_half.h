// SPDX-License-Identifier: MIT
// Half of a sphere's neighbourhood in a dense sorted grid, so that each pair is found once.
//
//       ┌───┬───┬───┐
//       │ ▒ │ ▒ │ ▒ │   The slots after the sphere's own in its cell and the next (▓), and the rows of three cells
//       ├───┼───┼───┤   above (▒), which are contiguous: two ranges in the plane, five in space. A border of empty
//       │   │ ● │ ▓ │   cells surrounds the grid, so every cell has these neighbours.
//       └───┴───┴───┘
//
// Cost: two reads of offsets a row. Its sibling for hashed grids is hashed_half.h.
#pragma once

#include "broad_phase/grid_rows.h"

namespace ballpit {

/// Visits what comes after a sphere of class k: slots from `from` on in its cell, at `bucket`, and in the next, then
/// the rows above. Rows out of reach are visited as empty ranges. Ranges have tags, since another class may be hashed.
template <class V, class Visit>
HOST_DEVICE void visit_dense_half(const ClassGrids<V>& grids, Span<const int> offsets, int k, int bucket, unsigned tag,
                                  const RowsReached& rows, int from, Visit&& visit) {
  const IVec3& cells = grids.grid[k].cells;
  const int* at = offsets.data() + grids.first_bucket[k] + bucket;
  visit(SlotRange{from, at[2], tag});
  for_each_row_after<kDimensions<V>>(rows, [&](int y, int z, int is_reached) {
    const int* row = at + (z * cells.y + y) * cells.x;
    const int first = row[-1], last = row[2];
    visit(SlotRange{first, first + ((last - first) & is_reached), tag + unsigned(z * cells.y + y)});
  });
}

}  // namespace ballpit
