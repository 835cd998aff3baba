// SPDX-License-Identifier: MIT
// Sorted grid: bodies sorted by cell, so that a cell is a range of slots, and so is a row of cells.
//
//     cell     0   1   2   3   4   5        slot     0   1   2   3   4       cell c holds slots
//     offsets  0   0   2   2   3   5  5     body     1   3   0   2   4       offsets[c] … offsets[c + 1] − 1
//                  └─── 2 bodies in cell 1: slots 0 and 1
//
// Each pair is found once: a body tests the slots after its own in its cell and the next, and the rows after its own
// (dense_half.h, hashed_half.h); in a periodic domain all cells within its reach, and there only slots after its own
// (grid_rows.h). Spheres of different sizes have a grid for each size class: a body searches its own class as above,
// and in each finer class the cells that its sphere reaches.
//
// A cell is one diameter long, and so wide that a row of three fills a vector of the processor. A body then reaches few
// of the rows beside its own. With --cell-size, one grid of cubes serves all sizes, and the whole block is searched, as
// on slides 7 and 16. A grid with far more cells than bodies is hashed: each slot then keeps the tag of its row (in
// periodic domains, of its cell), and each range names the tag that it wants.
//
// Cost: O(n + cells): one counting sort, one gather; then O(n) tests while cells hold O(1) bodies. Memory: 4 bytes a
// cell; per body 4 bytes and a copy of position and radius. Source: Green, "Particle simulation using CUDA" (2010),
// with half neighbourhoods. Its sibling with linked lists: linked_cell.h.
#pragma once

#include "bodies/bodies_view.h"
#include "broad_phase/dense_half.h"
#include "broad_phase/hashed_half.h"

namespace ballpit {

template <class V>
struct SortedGridCandidates {
  ClassGrids<V> grids;
  SlotsView<V> slots_view;
  Span<const int> offsets;

  HOST_DEVICE const SlotsView<V>& slots() const { return slots_view; }
  HOST_DEVICE int threads() const { return slots_view.count; }
  HOST_DEVICE int slot_of(int thread) const { return thread; }

  template <class Visit>
  HOST_DEVICE void for_each_range(int slot, Visit&& visit) const {
    const V p = slots_view.position(slot);
    const Scalar<V> radius = slots_view.radius[slot];
    const int own = grids.count == 1 ? 0 : grids.class_of(radius);
    visit_own(own, slot, p, radius, visit);
    for (int k = own + 1; k < grids.count; ++k) visit_reach(grids, offsets, k, p, radius, 0, visit);
  }

  /// The ranges of class k for a slot of class `own`.
  template <class Visit>
  void for_each_range_in(int k, int slot, int own, Visit&& visit) const {
    const V p = slots_view.position(slot);
    const Scalar<V> radius = slots_view.radius[slot];
    if (k > own) {
      visit_reach(grids, offsets, k, p, radius, 0, visit);
    } else {
      visit_own(k, slot, p, radius, visit);
    }
  }

  template <class Visit>
  void for_each_range_of(int from, int to, Visit&& visit) const {
    for (int slot = from; slot < to; ++slot) {
      for_each_range(slot, [&](const SlotRange& range) { visit(slot, range); });
    }
  }

  /// Calls visit(k, first, last) for slots first … last − 1 of each class k among slots from … to − 1.
  template <class Visit>
  void for_each_class(int from, int to, Visit&& visit) const {
    for (int k = 0; k < grids.count; ++k) {
      const int first = offsets[grids.first_bucket[k]], last = offsets[grids.first_bucket[k] + grids.grid[k].size()];
      if (first < to && from < last) visit(k, std::max(first, from), std::min(last, to));
    }
  }

 private:
  /// The ranges of a slot's own class.
  template <class Visit>
  HOST_DEVICE void visit_own(int own, int slot, const V& p, Scalar<V> radius, Visit&& visit) const {
    const Grid<V>& grid = grids.grid[own];
    if (grid.is_periodic) {
      visit_reach(grids, offsets, own, p, radius, slot + 1, visit);
      return;
    }
    const IVec3 cell = grid.cell_of(p);
    const RowsReached rows = rows_reached(grids, own, p, cell);
    if (grid.is_hashed) {
      visit_hashed_half(grids, offsets, own, cell, rows, slot + 1, visit);
    } else {
      visit_dense_half(grids, offsets, own, grid.index(cell), grid.row(cell.y, cell.z), rows, slot + 1, visit);
    }
  }
};

/// Key of the counting sort: the bucket of body i's cell.
template <class V>
struct BucketOfBody {
  ClassGrids<V> grids;
  Span<const V> position;
  PerBody<Scalar<V>> radius;

  HOST_DEVICE int operator()(int i) const {
    const int k = grids.count == 1 ? 0 : grids.class_of(radius[i]);
    const Grid<V>& grid = grids.grid[k];
    return grids.first_bucket[k] + grid.index(grid.cell_of(position[i]));
  }
};

/// The same for one dense grid that is not periodic, without branches: a loop of it compiles to vector instructions.
template <class V>
struct BucketInDenseGrid {
  Grid<V> grid;
  Span<const V> position;

  HOST_DEVICE int operator()(int i) const {
    const V p = position[i];
    const auto coordinate = [&](int axis) { return grid.coordinate_inside(p[axis], axis); };
    const int row = (kDimensions<V> == 3 ? coordinate(2) * grid.cells.y : 0) + coordinate(1);
    return row * grid.cells.x + coordinate(0);
  }
};

/// Kernel: the tag of a slot's cell.
template <class V>
struct StoreTag {
  ClassGrids<V> grids;
  SlotsView<V> slots;
  Span<unsigned> tag;

  HOST_DEVICE void operator()(int slot) const {
    const Grid<V>& grid = grids.grid[grids.class_of(slots.radius[slot])];
    tag[slot] = grid.tag(grid.cell_of(slots.position(slot)));
  }
};

template <class V, class Exec>
class SortedGrid {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  explicit SortedGrid(const BroadPhaseParameters<V>& parameters) { plan(parameters); }

  void plan(const BroadPhaseParameters<V>& parameters) {
    grids_ = ClassGrids<V>();
    buckets_ = 0;
    is_hashed_ = false;
    std::vector<SizeClass<V>> classes = parameters.classes;
    if (parameters.cell_size && !classes.empty()) classes = {{parameters.largest_radius(), parameters.count}};
    grids_.guard = static_cast<Scalar<V>>(rounding_guard(parameters.box));
    grids_.is_block = parameters.cell_size.has_value();
    for (const SizeClass<V>& spheres : classes) {
      const int k = grids_.count++;
      grids_.largest[k] = spheres.largest;
      grids_.first_bucket[k] = static_cast<int>(buckets_);
      const V edge = wanted_edge(parameters, spheres);
      Grid<V>& grid = grids_.grid[k] = make_grid(parameters, spheres, edge, is_hashed(parameters, spheres, edge));
      grids_.diameter[k] = diameter_in(grid, spheres);
      if (!grid.is_hashed && !grid.is_periodic) grid = with_border(grid);
      buckets_ += grid.size();
      is_hashed_ |= grid.is_hashed;
    }
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    offsets_.resize(buckets_ + 1);
    slots_.resize(bodies.size());
    const Span<int> offsets = offsets_.span(), body = slots_.body();
    if (grids_.count == 1 && grids_.is_dense(0)) {
      exec.bin_few("sort by cell", BucketInDenseGrid<V>{grids_.grid[0], bodies.position}, offsets, body);
    } else {
      exec.bin_few("sort by cell", BucketOfBody<V>{grids_, bodies.position, bodies.radius}, offsets, body);
    }
    slots_.gather(exec, bodies.position, bodies.radius);
    if (is_hashed_) {
      tag_.resize(bodies.size() + kSlotPadding);
      exec.parallel_for("store tags", bodies.size(), StoreTag<V>{grids_, slots_.view(), tag_.span()});
    }
  }

  SortedGridCandidates<V> candidates() const {
    SlotsView<V> slots = slots_.view();
    if (is_hashed_) slots.tag = tag_.span();
    return {grids_, slots, offsets_.span()};
  }

  std::vector<GridInspection> inspect(Exec& exec) const {
    const SlotsView<V> slots = slots_.view();
    const std::vector<int> body = exec.download(slots.body), offsets = exec.download(offsets_.span());
    std::vector<V> position(static_cast<size_t>(slots.count));
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const auto values = exec.download(slots.coordinate[axis]);
      for (size_t s = 0; s < position.size(); ++s) position[static_cast<size_t>(body[s])][axis] = values[s];
    }
    std::vector<GridInspection> result;
    for (int k = 0; k < grids_.count; ++k) {
      const int first = offsets[static_cast<size_t>(grids_.first_bucket[k])];
      const int last = offsets[static_cast<size_t>(grids_.first_bucket[k] + grids_.grid[k].size())];
      const std::vector<int> bodies(body.begin() + first, body.begin() + last);
      GridInspection seen = list_cells(grids_.grid[k], position, bodies);
      seen.arrays = CellArrays{true, grids_.grid[k].is_hashed, range_starts(k, seen.cells, offsets), bodies};
      result.push_back(std::move(seen));
    }
    return result;
  }

  int64_t bytes() const { return slots_.bytes() + offsets_.bytes() + tag_.bytes(); }

 private:
  /// Where each range begins among the bodies of class k, and at last where all end: of all buckets of a hashed grid,
  /// of all cells of a dense one but its border's.
  std::vector<int> range_starts(int k, const IVec3& cells, const std::vector<int>& offsets) const {
    const Grid<V>& grid = grids_.grid[k];
    const auto first = offsets.begin() + grids_.first_bucket[k], end = first + grid.size();
    std::vector<int> result;
    if (grid.is_hashed) {
      result.assign(first, end);
    } else {
      IVec3 border(0), cell(0);
      for (int axis = 0; axis < kDimensions<V>; ++axis) border[axis] = grid.border;
      for (cell.z = 0; cell.z < cells.z; ++cell.z) {
        for (cell.y = 0; cell.y < cells.y; ++cell.y) {
          for (cell.x = 0; cell.x < cells.x; ++cell.x) result.push_back(first[grid.index(cell + border)]);
        }
      }
    }
    result.push_back(*end);
    for (int& begin : result) begin -= *first;
    return result;
  }

  // Spheres in the three cells that are read of a row: about as many as a vector holds.
  static constexpr double kPerRow = 10;
  // Spheres per cubed (in the plane, squared) diameter of a heap.
  static constexpr double kHeap = kDimensions<V> == 3 ? 1.15 : 1.05;
  // Beyond that, reading and writing the offsets of empty cells costs more than checking tags.
  static constexpr double kMaxDenseCellsPerBody = 16;

  static V wanted_edge(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres) {
    const double length = 2 * double(spheres.largest);
    const double density = parameters.occupied_volume > 0 ? double(spheres.count) / parameters.occupied_volume
                                                          : kHeap / std::pow(length, kDimensions<V>);
    const double section = kPerRow / (3 * length * density);
    V edge(static_cast<Scalar<V>>(std::max(length, std::pow(section, 1.0 / (kDimensions<V> - 1)))));
    edge.x = static_cast<Scalar<V>>(length);
    return edge;
  }

  /// The largest sphere's diameter in cells. With --cell-size larger than any number of cells: all rows are reached.
  V diameter_in(const Grid<V>& grid, const SizeClass<V>& spheres) const {
    V result(Scalar<V>(1e30));
    for (int axis = 0; axis < kDimensions<V> && !grids_.is_block; ++axis) {
      const double reach = 2 * double(spheres.largest) * 1.000001 + double(grids_.guard);
      const double rounding = 4.0 * double(std::numeric_limits<Scalar<V>>::epsilon()) * double(grid.farthest[axis]);
      result[axis] = static_cast<Scalar<V>>(reach / double(grid.edge[axis]) + rounding);
    }
    return result;
  }

  static bool is_hashed(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres, const V& edge) {
    if (parameters.table != CellTable::automatic) return parameters.table == CellTable::hashed;
    return !parameters.cell_size &&
           cell_count(parameters.box, edge) > kMaxDenseCellsPerBody * double(spheres.count) + 4096;
  }

  ClassGrids<V> grids_;
  int64_t buckets_ = 0;
  bool is_hashed_ = false;  // at least one of the grids
  Slots<V, Exec> slots_;
  Buffer<int> offsets_;
  Buffer<unsigned> tag_;
};

}  // namespace ballpit
