// SPDX-License-Identifier: MIT
// The uniform grid over a domain: which cell a point lies in, which cells are around a cell, and where in an array a
// cell has its place.
//
//     ┌────┬────┬────┐
//     │ 6  │ 7  │ 8  │    dense: index = (z · cells.y + y) · cells.x + x      (slide 9, in two or three dimensions)
//     ├────┼────┼────┤
//     │ 3  │ 4  │ 5  │    a sphere in cell 4 touches no sphere outside the 3 × 3 (× 3) block around it,
//     ├────┼────┼────┤    if the edge is at least 2·r_max
//     │ 0  │ 1  │ 2  │
//     └────┴────┴────┘    hashed: index = (hash(y, z) + x) mod 2^k
//
// A dense grid has a place for each cell of the domain; spheres beyond its border count to the cells at the border. A
// hashed grid has a number of places that depends on the number of spheres alone, however large the domain, and cells
// without a border; cells may share a place, so who looks into one must check whose cell it is. Cells that are neighbours
// along x have neighbouring places in both.
//
// Slide 7 prints the bound Δcell ≥ r_min; the block is complete only from 2·r_max on (docs/model.md shows why).
// Hashing: Teschner et al., "Optimized Spatial Hashing for Collision Detection of Deformable Objects" (2003).
#pragma once

#include <cmath>

#include "bodies/box.h"
#include "broad_phase/inspection.h"
#include "broad_phase/parameters.h"

namespace ballpit {

template <class V>
struct Grid {
  using Real = Scalar<V>;
  V origin{};
  V edge{};           ///< [m] stretched in periodic domains to fit a whole number of times
  V inverse_edge{};   ///< [1/m]
  IVec3 cells{1};     ///< of the domain; a hashed grid has more, unless it is periodic
  int border = 0;     ///< cells around the domain's that no body counts to, so that each body's cell has all neighbours
  unsigned mask = 0;  ///< hashed grids: number of places − 1
  V farthest{
      Real(2048)};  ///< hashed grids that are not periodic: cells farther out count as this one, lest rounding matter
  bool is_hashed = false;
  bool is_periodic = false;

  /// Places in the array.
  HOST_DEVICE int64_t size() const { return is_hashed ? int64_t(mask) + 1 : int64_t(cells.x) * cells.y * cells.z; }

  /// The row of cells (·, y, z): a number below 2³¹ that differs from those of all rows within 32 767 of it.
  HOST_DEVICE unsigned row(int y, int z) const {
    return is_hashed ? (unsigned(z) * 65536u + unsigned(y)) & 0x7FFFFFFFu : unsigned(z * cells.y + y);
  }

  /// Tells the cells that may share a place from each other: by row, and in periodic domains by cell, where places that
  /// wrap around meet cells that do.
  HOST_DEVICE unsigned tag(const IVec3& cell) const {
    return is_periodic ? unsigned((cell.z * cells.y + cell.y) * cells.x + cell.x) : row(cell.y, cell.z);
  }

  /// The place of cell (0, y, z). Wraps around at the end of a hashed grid.
  HOST_DEVICE unsigned row_place(unsigned row) const {
    if (!is_hashed) return row * unsigned(cells.x);
    unsigned hash = row * 0x9E3779B1u;  // Knuth's multiplier, mixed so that the low bits depend on all
    hash ^= hash >> 15;
    return hash * 0x85EBCA77u;
  }

  HOST_DEVICE int place(unsigned row_place, int x) const {
    const unsigned at = row_place + unsigned(x);
    return int(is_hashed ? at & mask : at);
  }
  HOST_DEVICE int index(const IVec3& cell) const { return place(row_place(row(cell.y, cell.z)), cell.x); }

  HOST_DEVICE int coordinate_of(Real p, int axis) const {
    const Real x = scaled(p, axis);
    if (is_hashed && !is_periodic) {
      const Real far = farthest[axis];
      const Real limited = x > -far ? (x < far ? x : far) : -far;  // NaN too
      const int truncated = int(limited);
      return truncated - int(limited < Real(truncated));
    }
    const Real first = Real(border), last = Real(cells[axis] - 1 - border);
    const Real limited = x < last ? x : last;
    return int(limited > first ? limited : first);
  }

  /// Where in cell c of an axis a coordinate lies: from 0 to 1, beyond the outermost cells also outside of that.
  HOST_DEVICE Real place_in(int c, Real p, int axis) const { return scaled(p, axis) - Real(c); }

  /// The cell of a point.
  HOST_DEVICE IVec3 cell_of(const V& p) const {
    IVec3 cell(0);
    for (int axis = 0; axis < kDimensions<V>; ++axis) cell[axis] = coordinate_of(p[axis], axis);
    return cell;
  }

  /// First and last neighbour of coordinate c along an axis, c itself included: each cell once, also where a periodic
  /// axis has fewer than three. Wrap with wrapped().
  HOST_DEVICE void neighbours(int axis, int c, int& first, int& last) const {
    const int n = cells[axis];
    first = c - 1;
    last = c + 1;
    if (is_periodic) {
      if (n < 3) {
        first = c;
        last = c + n - 1;
      }
    } else if (!is_hashed && border == 0) {
      if (first < 0) first = 0;
      if (last > n - 1) last = n - 1;
    }
  }
  HOST_DEVICE int wrapped(int axis, int c) const {
    if (!is_periodic) return c;
    const int n = cells[axis];
    return c < 0 ? c + n : (c >= n ? c - n : c);
  }

  /// Calls visit(cell) for each cell of the block around `center` until visit returns false.
  template <class Visit>
  HOST_DEVICE void for_each_neighbour(const IVec3& center, Visit&& visit) const {
    int z0 = 0, z1 = 0, y0, y1, x0, x1;
    if constexpr (kDimensions<V> == 3) neighbours(2, center.z, z0, z1);
    neighbours(1, center.y, y0, y1);
    neighbours(0, center.x, x0, x1);
    for (int z = z0; z <= z1; ++z) {
      for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
          if (!visit(IVec3(wrapped(0, x), wrapped(1, y), wrapped(2, z)))) return;
        }
      }
    }
  }

 private:
  /// A coordinate [m] counted in cells.
  HOST_DEVICE Real scaled(Real p, int axis) const { return (p - origin[axis]) * inverse_edge[axis]; }
};

/// What a coordinate may be off by rounding [m]: a few units in the last place of the largest one.
template <class V>
double rounding_guard(const Box<V>& box);

/// The number of cells of a dense grid with these edges [m].
template <class V>
double cell_count(const Box<V>& box, const V& edge);

/// A grid over the domain for spheres of one size class, with cells of these edges [m], or with --cell-size of so many of
/// the class's largest diameters. In a dense grid they are larger where there would be far more cells than spheres. A
/// rounding guard keeps spheres that touch within neighbouring cells, where an edge is a diameter or more. Throws UserError
/// where there are more cells than an index holds.
template <class V>
Grid<V> make_grid(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres, const V& edge,
                  bool is_hashed);

/// The grid with lists of its cells for the audience, built on the host; without them where there are too many cells to
/// look at.
template <class V>
GridInspection list_cells(const Grid<V>& grid, const std::vector<V>& position, const std::vector<int>& bodies);

/// Surrounds a grid with a border of cells that stay empty.
template <class V>
Grid<V> with_border(Grid<V> grid) {
  grid.border = 1;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    grid.origin[axis] -= grid.edge[axis];
    grid.cells[axis] += 2;
  }
  return grid;
}

/// The grid without its border, and without lists.
template <class V>
GridInspection describe_grid(const Grid<V>& grid) {
  GridInspection result;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    result.cells[axis] = grid.cells[axis] - 2 * grid.border;
    result.origin[axis] = static_cast<float>(grid.origin[axis] + grid.edge[axis] * Scalar<V>(grid.border));
    result.edge[axis] = static_cast<float>(grid.edge[axis]);
  }
  if constexpr (kDimensions<V> == 2) result.cells.z = 1;
  return result;
}

}  // namespace ballpit
