// SPDX-License-Identifier: MIT
// Tests the spheres of dense sorted grids (dense_half.h, grid_rows.h) by vectors: not only the distances, as in
// range_tests.h, but also the cells and the rows that spheres reach are computed for a vector of slots at a time.
//
//     slots   16 17 18 19 …      cells, and which rows each slot reaches, as masks
//     rows    (16, 20–23) (18, 20–23) (17, 52–55) …     slot and buckets, one row of all slots after the other:
//                                                       compressed by the masks, so without a branch for each slot
//     tests   slot 16 against slots offsets[20] … offsets[23] − 1, …
//
// Pairs and tests are those of SortedGridCandidates::for_each_range(). Cost: a tenth of its instructions a slot, and
// the tests.
#pragma once

#include "broad_phase/grid_rows.h"
#include "narrow_phase/pair_blocks.h"

namespace ballpit {

/// Spheres sorted into grids, of which those that are searched are neither hashed nor periodic.
template <class V>
struct DenseCells {
  const ClassGrids<V>& grids;
  Span<const int> offsets;
  SlotsView<V> slots;
};

/// Tests slots first … last − 1, all of class `own`, against those of class k: of their own class those after them, of
/// a finer one all within reach. Appends the pairs in contact, lower body first. Returns the number of tests.
template <class V>
using TestCells = int64_t (*)(const DenseCells<V>& cells, int own, int k, int first, int last, PairBuffer& found);

/// By the best instructions of this processor, for Vec2 and Vec3.
template <class V>
TestCells<V> cell_tests();

}  // namespace ballpit
