// SPDX-License-Identifier: MIT
// Which cells of a sorted grid a sphere reaches, row by row: a row of cells along x is one range of slots.
//
//       ┌───┬───┬───┐
//       │   │ ▒ │ ▒ │   y = 2    a sphere (●) and the rows of cells that hold all centres within its reach
//       ├───┼───┼───┤
//       │   │ ● │ ▒ │   y = 1    each row: offsets[first cell] … offsets[last cell + 1]
//       ├───┼───┼───┤
//       │   │ ▒ │ ▒ │   y = 0
//       └───┴───┴───┘
//
// Spheres of different sizes have a grid for each size class (size_classes() of parameters.h), largest spheres first,
// with their buckets one after another in the same array. Source: Ericson, "Real-Time Collision Detection" (2005),
// section 7.2.
//
//     radii      0.5 0.4   │   0.1 0.1 0.08
//     class         0      │        1
//     buckets    0 … 63    │   64 … 4159         first_bucket = {0, 64}
//
// Serves periodic domains and the grids of finer size classes. Cost: two reads a row; in periodic domains, whose cells
// wrap around, two a cell. Siblings that visit only half of a sphere's neighbourhood: dense_half.h, hashed_half.h.
#pragma once

#include "bodies/slots.h"
#include "broad_phase/grid.h"

namespace ballpit {

template <class V>
struct ClassGrids {
  using Real = Scalar<V>;
  int count = 0;
  bool is_block = false;               ///< searches the 3 × 3 (× 3) block, whatever a sphere reaches (--cell-size)
  Real guard = 0;                      ///< bound on the rounding error of a distance [m]
  Real largest[kMaxSizeClasses] = {};  ///< [m] radius, descending
  V diameter[kMaxSizeClasses] = {};    ///< [cells] of the largest sphere, rounding error included
  int first_bucket[kMaxSizeClasses] = {};  ///< of each class
  Grid<V> grid[kMaxSizeClasses] = {};

  /// Without a branch for each class, which would be hard to predict.
  HOST_DEVICE int class_of(Real radius) const {
    int finer = 0;
    for (int k = 1; k < count; ++k) finer += int(radius <= largest[k]);
    return finer;
  }

  /// Whether class k has a bucket for each cell, and an end. The CPU searches such grids by vectors
  /// (narrow_phase/cell_tests.h).
  bool is_dense(int k) const { return !grid[k].is_hashed && !grid[k].is_periodic; }

  /// The offsets of class k: bucket b of its grid holds slots offsets[b] … offsets[b + 1] − 1.
  HOST_DEVICE Span<const int> offsets_of(int k, Span<const int> offsets) const {
    return {offsets.data() + first_bucket[k], offsets.size() - first_bucket[k]};
  }
};

/// Visits cells x0 … x1 of a row of class k: one range, or two where the buckets of a hashed grid wrap around. `from` >
/// 0: the first slot of the first cell that is visited.
template <class V, class Visit>
HOST_DEVICE void visit_row(const ClassGrids<V>& grids, Span<const int> all_offsets, int k, int y, int z, int x0, int x1,
                           int from, Visit&& visit) {
  const Grid<V>& grid = grids.grid[k];
  const unsigned row = grid.row(y, z);
  const unsigned start = grid.row_start(row);
  const bool is_whole = grid.is_hashed && x1 - x0 >= int(grid.mask);
  const int first = is_whole ? 0 : grid.index(start, x0), last = is_whole ? int(grid.mask) : grid.index(start, x1);
  const Span<const int> offsets = grids.offsets_of(k, all_offsets);
  const int begin = from > 0 ? from : offsets[first];
  visit(SlotRange{begin, offsets[first <= last ? last + 1 : int(grid.mask) + 1], row});
  if (first > last) visit(SlotRange{offsets[0], offsets[last + 1], row});
}

/// The first and last cells of class k that may hold the centre of a sphere that touches one at p. In a periodic domain
/// each cell comes once, and has to be wrapped.
template <class V>
HOST_DEVICE void find_reach(const ClassGrids<V>& grids, int k, const V& p, Scalar<V> radius, IVec3& low, IVec3& high) {
  using Real = Scalar<V>;
  const Grid<V>& grid = grids.grid[k];
  const Real reach = (radius + grids.largest[k]) * Real(1.000001) + grids.guard;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    if (grids.is_block) {
      grid.neighbours(axis, grid.coordinate_of(p[axis], axis), low[axis], high[axis]);
    } else if (!grid.is_periodic) {
      low[axis] = grid.coordinate_of(p[axis] - reach, axis);
      high[axis] = grid.coordinate_of(p[axis] + reach, axis);
    } else {
      // Compared before the conversion to integers, so that NaN and far positions give cells inside the grid, too.
      const Real cells = Real(grid.cells[axis]);
      const Real first = std::floor((p[axis] - reach - grid.origin[axis]) * grid.inverse_edge[axis]);
      const Real last = std::floor((p[axis] + reach - grid.origin[axis]) * grid.inverse_edge[axis]);
      const bool is_part = first >= -cells && last < 2 * cells && last - first < cells;
      low[axis] = is_part ? int(first) : 0;
      high[axis] = is_part ? int(last) : grid.cells[axis] - 1;
    }
  }
}

/// Visits the cells of class k that a sphere reaches: slots from `from` on.
template <class V, class Visit>
HOST_DEVICE void visit_reach(const ClassGrids<V>& grids, Span<const int> all_offsets, int k, const V& p,
                             Scalar<V> radius, int from, Visit&& visit) {
  const Grid<V>& grid = grids.grid[k];
  IVec3 low(0), high(0);
  find_reach(grids, k, p, radius, low, high);
  // Where a sphere reaches more rows than the class has spheres, testing all of them is faster.
  const Span<const int> offsets = grids.offsets_of(k, all_offsets);
  const int first = offsets[0], last = offsets[grid.size()];
  double lookups = (double(high.y) - low.y + 1) * (double(high.z) - low.z + 1);
  if (grid.is_periodic) lookups *= double(high.x) - low.x + 1;
  if (lookups > double(last - first)) {
    visit(SlotRange{first < from ? from : first, last, kAnyTag});
    return;
  }
  for (int z = low.z; z <= high.z; ++z) {
    for (int y = low.y; y <= high.y; ++y) {
      if (!grid.is_periodic) {
        visit_row(grids, all_offsets, k, y, z, low.x, high.x, 0, visit);
        continue;
      }
      for (int x = low.x; x <= high.x; ++x) {
        const IVec3 cell(grid.wrapped(0, x), grid.wrapped(1, y), grid.wrapped(2, z));
        const int bucket = grid.index(cell);
        visit(SlotRange{offsets[bucket] < from ? from : offsets[bucket], offsets[bucket + 1], grid.tag(cell)});
      }
    }
  }
}

/// Which of the rows beside its own a sphere reaches: all bits set, or none. Masks replace branches, which a processor
/// could not predict.
struct RowsReached {
  int is_up, is_down, is_front;
};

template <class V>
HOST_DEVICE RowsReached rows_reached(const ClassGrids<V>& grids, int k, const V& p, const IVec3& cell) {
  const Grid<V>& grid = grids.grid[k];
  const V& diameter = grids.diameter[k];
  const Scalar<V> y = grid.offset_in(cell.y, p[1], 1);
  RowsReached rows{-int(y > 1 - diameter[1]), -int(y < diameter[1]), 0};
  if constexpr (kDimensions<V> == 3) rows.is_front = -int(grid.offset_in(cell.z, p[2], 2) > 1 - diameter[2]);
  return rows;
}

/// Calls visit(y, z, is_reached) for the rows that come after a sphere's own: one in the plane, four in space.
template <int kAxes, class Visit>
HOST_DEVICE void for_each_row_after(const RowsReached& rows, Visit&& visit) {
  visit(1, 0, rows.is_up);
  if constexpr (kAxes == 3) {
    visit(-1, 1, rows.is_front & rows.is_down);
    visit(0, 1, rows.is_front);
    visit(1, 1, rows.is_front & rows.is_up);
  }
}

}  // namespace ballpit
