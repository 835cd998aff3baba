// SPDX-License-Identifier: MIT
// The uniform grid over a domain: the cell of a point, the cells around a cell, and the bucket of a cell in an array.
//
//     ┌────┬────┬────┐
//     │ 6  │ 7  │ 8  │    dense: bucket = (z · cells.y + y) · cells.x + x      (slide 9, in two or three dimensions)
//     ├────┼────┼────┤
//     │ 3  │ 4  │ 5  │    a sphere in cell 4 touches no sphere outside the 3 × 3 (× 3) block around it,
//     ├────┼────┼────┤    if the edge is at least 2·r_max
//     │ 0  │ 1  │ 2  │
//     └────┴────┴────┘    hashed: bucket = (hash(y, z) + x) mod 2^k
//
// A dense grid has one bucket for each cell of the domain. Spheres beyond its border belong to the cells at the border.
// A hashed grid has a number of buckets that depends only on the number of spheres, however large the domain is, and
// its cells have no border. Several cells may share a bucket, so a search must check the cell of each entry. In both,
// cells that are neighbours along x have neighbouring buckets.
//
// Slide 7 prints the bound Δcell ≥ r_min; the block is complete only from 2·r_max on (docs/model.md shows why).
// Hashing: Teschner et al., "Optimized Spatial Hashing for Collision Detection of Deformable Objects" (2003).
#pragma once

#include "bodies/box.h"
#include "broad_phase/inspection.h"
#include "broad_phase/parameters.h"

namespace ballpit {

template <class V>
struct Grid {
  using Real = Scalar<V>;
  V origin{};
  V edge{};           ///< [m] in periodic domains stretched so that a whole number of cells fits
  V inverse_edge{};   ///< [1/m]
  IVec3 cells{1};     ///< of the domain; a hashed grid has more, unless it is periodic
  int border = 0;     ///< empty cells around the domain's, so that each body's cell has all neighbours
  unsigned mask = 0;  ///< hashed grids: number of buckets − 1
  V farthest{
      Real(2048)};  ///< [cells] hashed, not periodic: positions farther out count as this far, where floats are exact
  bool is_hashed = false;
  bool is_periodic = false;

  /// The number of buckets.
  HOST_DEVICE int64_t size() const { return is_hashed ? int64_t(mask) + 1 : int64_t(cells.x) * cells.y * cells.z; }

  /// The row of cells (·, y, z): a number below 2³¹ that differs from those of all rows within 32 767 of it.
  HOST_DEVICE unsigned row(int y, int z) const {
    return is_hashed ? (unsigned(z) * 65536u + unsigned(y)) & 0x7FFFFFFFu : unsigned(z * cells.y + y);
  }

  /// A number that distinguishes the cells that may share a bucket: the row, and in periodic domains, where both
  /// buckets and cells wrap around, the cell.
  HOST_DEVICE unsigned tag(const IVec3& cell) const {
    return is_periodic ? unsigned((cell.z * cells.y + cell.y) * cells.x + cell.x) : row(cell.y, cell.z);
  }

  /// The bucket of cell (0, y, z); in a hashed grid before it wraps around at the end.
  HOST_DEVICE unsigned row_start(unsigned row) const {
    if (!is_hashed) return row * unsigned(cells.x);
    unsigned hash = row * 0x9E3779B1u;  // Knuth's multiplier, mixed so that the low bits depend on all
    hash ^= hash >> 15;
    return hash * 0x85EBCA77u;
  }

  /// The bucket of a cell.
  HOST_DEVICE int index(unsigned row_start, int x) const {
    const unsigned at = row_start + unsigned(x);
    return int(is_hashed ? at & mask : at);
  }
  HOST_DEVICE int index(const IVec3& cell) const { return index(row_start(row(cell.y, cell.z)), cell.x); }

  HOST_DEVICE int coordinate_of(Real p, int axis) const {
    const Real x = scaled(p, axis);
    if (is_hashed && !is_periodic) {
      const Real far = farthest[axis];
      const Real limited = x > -far ? (x < far ? x : far) : -far;  // NaN too
      const int truncated = int(limited);
      return truncated - int(limited < Real(truncated));
    }
    return inside(x, axis);
  }

  /// The same in a grid that is not hashed, or is periodic.
  HOST_DEVICE int coordinate_inside(Real p, int axis) const { return inside(scaled(p, axis), axis); }

  /// How far behind the start of cell c a coordinate lies [cells]: 0 to 1 inside the cell.
  HOST_DEVICE Real offset_in(int c, Real p, int axis) const { return scaled(p, axis) - Real(c); }

  /// The cell of a point.
  HOST_DEVICE IVec3 cell_of(const V& p) const {
    IVec3 cell(0);
    for (int axis = 0; axis < kDimensions<V>; ++axis) cell[axis] = coordinate_of(p[axis], axis);
    return cell;
  }

  /// First and last neighbour of coordinate c along an axis, c itself included. Each cell comes once, even if a
  /// periodic axis has fewer than three. Wrap with wrapped().
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
  /// The cell at x, in units of cells, or the nearest one with bodies.
  HOST_DEVICE int inside(Real x, int axis) const {
    const Real first = Real(border), last = Real(cells[axis] - 1 - border);
    const Real limited = x < last ? x : last;
    return int(limited > first ? limited : first);
  }

  /// A coordinate in units of cells.
  HOST_DEVICE Real scaled(Real p, int axis) const { return (p - origin[axis]) * inverse_edge[axis]; }
};

/// Bound on the rounding error of a coordinate [m]: a few units in the last place of the largest one.
template <class V>
double rounding_guard(const Box<V>& box);

/// The number of cells of a dense grid with these edges [m].
template <class V>
double cell_count(const Box<V>& box, const V& edge);

/// A grid over the domain for spheres of one size class. `edge` [m] is the wanted edge of its cells; --cell-size
/// overrides it by a multiple of the class's largest diameter. A dense grid with far more cells than spheres gets
/// larger cells. A guard against rounding keeps spheres that touch within neighbouring cells, if an edge is at least a
/// diameter. Throws UserError if there are more cells than an index can hold.
template <class V>
Grid<V> make_grid(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres, const V& edge,
                  bool is_hashed);

/// Surrounds a grid with a border of empty cells.
template <class V>
Grid<V> with_border(Grid<V> grid) {
  grid.border = 1;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    grid.origin[axis] -= grid.edge[axis];
    grid.cells[axis] += 2;
  }
  return grid;
}

/// The grid without its border, for the audience. Its cell lists stay empty.
template <class V>
GridInspection describe_grid(const Grid<V>& grid);

/// The same with cell lists, built on the host, unless there are too many cells to look at.
template <class V>
GridInspection list_cells(const Grid<V>& grid, const std::vector<V>& position, const std::vector<int>& bodies);

}  // namespace ballpit
