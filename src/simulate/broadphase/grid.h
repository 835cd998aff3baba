// SPDX-License-Identifier: MIT
// The uniform grid over a domain: which cell a point lies in, and which cells are around a cell.
//
//     ┌────┬────┬────┐
//     │ 6  │ 7  │ 8  │    index = (z · cells.y + y) · cells.x + x      (slide 9, in two or three dimensions)
//     ├────┼────┼────┤
//     │ 3  │ 4  │ 5  │    a sphere in cell 4 touches no sphere outside the 3 × 3 (× 3) block around it,
//     ├────┼────┼────┤    if the edge is at least 2·r_max
//     │ 0  │ 1  │ 2  │
//     └────┴────┴────┘
//
// Slide 7 prints the bound Δcell ≥ r_min; the block is complete only from 2·r_max on (docs/model.md shows why).
#pragma once

#include <cmath>

#include "simulate/broadphase/parameters.h"
#include "simulate/state.h"

namespace ballpit {

template <class V>
struct Grid {
  using Real = Scalar<V>;
  V origin{};
  V edge{};          ///< [m] equal along all axes, but stretched in periodic domains to fit a whole number of times
  V inverse_edge{};  ///< [1/m]
  IVec3 cells{1};
  bool is_periodic = false;

  HOST_DEVICE int64_t size() const { return int64_t(cells.x) * cells.y * cells.z; }
  HOST_DEVICE int index(const IVec3& cell) const { return (cell.z * cells.y + cell.y) * cells.x + cell.x; }

  /// The cell of a point. Points beyond the border count to the cells at the border, which keeps neighbours neighbours.
  HOST_DEVICE IVec3 cell_of(const V& p) const {
    IVec3 cell(0);
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const Real x = std::floor((p[axis] - origin[axis]) * inverse_edge[axis]);
      const Real last = Real(cells[axis] - 1);
      cell[axis] = static_cast<int>(x < 0 ? Real(0) : (x > last ? last : x));
    }
    return cell;
  }

  /// First and last neighbour of coordinate c along an axis, c itself included: each cell once, also where a periodic
  /// axis has fewer than three. Wrap with wrapped().
  HOST_DEVICE void neighbours(int axis, int c, int& first, int& last) const {
    const int n = cells[axis];
    first = c - 1;
    last = c + 1;
    if (!is_periodic) {
      if (first < 0) first = 0;
      if (last > n - 1) last = n - 1;
    } else if (n < 3) {
      first = c;
      last = c + n - 1;
    }
  }
  HOST_DEVICE int wrapped(int axis, int c) const {
    if (!is_periodic) return c;
    const int n = cells[axis];
    return c < 0 ? c + n : (c >= n ? c - n : c);
  }

  /// Calls visit(index) for each cell of the block around `center` until visit returns false.
  template <class Visit>
  HOST_DEVICE void for_each_neighbour(const IVec3& center, Visit&& visit) const {
    int z0 = 0, z1 = 0, y0, y1, x0, x1;
    if constexpr (kDimensions<V> == 3) neighbours(2, center.z, z0, z1);
    neighbours(1, center.y, y0, y1);
    neighbours(0, center.x, x0, x1);
    for (int z = z0; z <= z1; ++z) {
      for (int y = y0; y <= y1; ++y) {
        const int row = (wrapped(2, z) * cells.y + wrapped(1, y)) * cells.x;
        for (int x = x0; x <= x1; ++x) {
          if (!visit(row + wrapped(0, x))) return;
        }
      }
    }
  }
};

/// The grid for a scene. Without a cell size the edge is 2·r_max, or larger where that many cells would be mostly empty.
/// A rounding guard keeps spheres that touch within neighbouring cells. Throws UserError where there are more cells
/// than an index holds.
template <class V>
Grid<V> make_grid(const BroadPhaseParameters<V>& parameters);

extern template Grid<Vec2> make_grid(const BroadPhaseParameters<Vec2>&);
extern template Grid<Vec3> make_grid(const BroadPhaseParameters<Vec3>&);

}  // namespace ballpit
