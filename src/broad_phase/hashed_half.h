// SPDX-License-Identifier: MIT
// Half of a sphere's neighbourhood in a hashed sorted grid, so that each pair is found once.
//
//     rows of cells      y = 1   ▒ ▒ ▒           buckets   │ ▒ │   │ ▓ │ ▓ │   │ ▒ │ ▒ │      row y = 1 wraps around:
//                        y = 0     ● ▓                       ▲──── continues ────┘            two ranges
//
// The same rows as in dense_half.h. The grid has no border, and rows lie anywhere in the table. Rows may share buckets,
// so a slot has the tag of its row, and each range names the tag that it wants. Cost: one hash and two reads of offsets
// a row.
#pragma once

#include "broad_phase/grid_rows.h"

namespace ballpit {

/// Visits what comes after a sphere of class k in `cell`: slots from `from` on in its cell and the next, then the rows
/// above that it reaches.
template <class V, class Visit>
HOST_DEVICE void visit_hashed_half(const ClassGrids<V>& grids, Span<const int> offsets, int k, const IVec3& cell,
                                   const RowsReached& rows, int from, Visit&& visit) {
  visit_row(grids, offsets, k, cell.y, cell.z, cell.x, cell.x + 1, from, visit);
  for_each_row_after<kDimensions<V>>(rows, [&](int y, int z, int is_reached) {
    if (is_reached) visit_row(grids, offsets, k, cell.y + y, cell.z + z, cell.x - 1, cell.x + 1, 0, visit);
  });
}

}  // namespace ballpit
