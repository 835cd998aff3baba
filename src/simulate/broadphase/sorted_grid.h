// SPDX-License-Identifier: MIT
// Sorted grid: bodies sorted by their cells, so that a cell is a range of slots, and so are cells in a row.
//
//     cell     0   1   2   3   4   5        slot     0   1   2   3   4
//     offsets  0   0   2   2   3   5  5     body     1   3   0   2   4       cell c holds slots offsets[c] … offsets[c+1]−1
//                  └─── 2 bodies in cell 1: slots 0 and 1
//
//       ┌───┬───┬───┐
//       │ ▒ │ ▒ │ ▒ │   Each pair once: a body looks at the slots after its own in its cell and the next (▓), and at
//       ├───┼───┼───┤   the rows of three cells above (▒), which are contiguous: two ranges in the plane, five in
//       │   │ ▓ │ ▓ │   space. In periodic domains it looks at all neighbours, at the slots after its own.
//       └───┴───┴───┘
//
// Spheres of different sizes: a grid for each size class (a factor of about 2.5), one after the other in the same arrays, largest
// first. A body looks in its own class as above, and in each finer class at the cells that its sphere reaches: a large
// sphere reads long rows of small ones, a small one never reads cells made for large ones. With --cell-size, one grid
// serves all, as on slide 7.
//
// Where a dense grid would have far more cells than bodies, the cells are hashed: a slot then keeps the tag of its row (in
// periodic domains, of its cell), and ranges tell which tag they want.
//
// Cost: O(n + cells): one counting sort, one gather; then O(n) tests while cells hold O(1) bodies. Memory: 4 bytes a cell;
// per body 4 bytes and a copy of position and radius. Source: Green, "Particle simulation using CUDA" (2010), with
// half neighbourhoods; size classes: Ericson, "Real-Time Collision Detection" (2005), section 7.2.
// Sibling with lists in place of ranges: linked_cell.h.
#pragma once

#include "simulate/broadphase/grid.h"
#include "simulate/slots.h"

namespace ballpit {

/// The grids of all size classes, in one array of cells.
template <class V>
struct ClassGrids {
  using Real = Scalar<V>;
  int count = 0;
  Real guard = 0;                         ///< what rounding may add to a distance [m]
  Real largest[kMaxSizeClasses] = {};     ///< [m] radius, falling
  int first_place[kMaxSizeClasses] = {};  ///< where the places of a class's cells begin
  Grid<V> grid[kMaxSizeClasses] = {};

  HOST_DEVICE int class_of(Real radius) const {
    int k = 0;
    while (k + 1 < count && radius <= largest[k + 1]) ++k;
    return k;
  }
};

/// Key of the counting sort: the place of body i's cell.
template <class V>
struct PlaceOfBody {
  ClassGrids<V> grids;
  Span<const V> position;
  PerBody<Scalar<V>> radius;

  HOST_DEVICE int operator()(int i) const {
    const int k = grids.count == 1 ? 0 : grids.class_of(radius[i]);
    const Grid<V>& grid = grids.grid[k];
    return grids.first_place[k] + grid.index(grid.cell_of(position[i]));
  }
};

/// Kernel: the tag of the cell that a slot lies in.
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

template <class V>
struct SortedGridCandidates {
  using Real = Scalar<V>;
  ClassGrids<V> grids;
  SlotsView<V> slots_view;
  Span<const int> offsets;

  HOST_DEVICE const SlotsView<V>& slots() const { return slots_view; }
  HOST_DEVICE int threads() const { return slots_view.count; }
  HOST_DEVICE int slot_of(int thread) const { return thread; }

  template <class Visit>
  HOST_DEVICE void for_each_range(int slot, Visit&& visit) const {
    const V p = slots_view.position(slot);
    const Real radius = slots_view.radius[slot];
    const int own = grids.count == 1 ? 0 : grids.class_of(radius);
    if (grids.grid[own].is_periodic) {
      visit_all_neighbours(own, p, slot, visit);
    } else if (grids.grid[own].is_hashed) {
      visit_half_of_hashed(own, grids.grid[own].cell_of(p), slot + 1, visit);
    } else {
      visit_half_of_dense(own, grids.grid[own].cell_of(p), slot + 1, visit);
    }
    for (int k = own + 1; k < grids.count; ++k) visit_reach(k, p, radius, visit);
  }

  /// Slots of one cell share their ranges, unless each also reaches into finer classes by its own size.
  template <class Visit>
  int for_each_range_of_group(int slot, int limit, Visit&& visit) const {
    const int own = grids.count == 1 ? 0 : grids.class_of(slots_view.radius[slot]);
    const Grid<V>& grid = grids.grid[own];
    if (own + 1 < grids.count || grid.is_periodic) {
      for_each_range(slot, visit);
      return slot + 1;
    }
    const IVec3 cell = grid.cell_of(slots_view.position(slot));
    const int bin_end = offsets_of(own)[grid.index(cell) + 1];
    int end = bin_end < limit ? bin_end : limit;
    if (grid.is_hashed) {
      int same = slot + 1;
      while (same < end && grid.cell_of(slots_view.position(same)) == cell) ++same;
      visit_half_of_hashed(own, cell, end = same, visit);
    } else {
      visit_half_of_dense(own, cell, end, visit);
    }
    return end;
  }

 private:
  /// Visits cells x0 … x1 of a row of an unbounded grid: in one range, or in two where the places wrap around.
  template <class Visit>
  HOST_DEVICE void visit_row(int k, int y, int z, int x0, int x1, Visit&& visit) const {
    const Grid<V>& grid = grids.grid[k];
    const unsigned row = grid.row(y, z);
    const unsigned start = grid.row_place(row);
    const bool is_whole = grid.is_hashed && x1 - x0 >= int(grid.mask);
    const int first = is_whole ? 0 : grid.place(start, x0), last = is_whole ? int(grid.mask) : grid.place(start, x1);
    const Span<const int> at = offsets_of(k);
    if (first <= last) {
      visit(SlotRange{at[first], at[last + 1], row});
    } else {
      visit(SlotRange{at[first], at[int(grid.mask) + 1], row});
      visit(SlotRange{at[0], at[last + 1], row});
    }
  }

  /// Visits a cell of a periodic grid: its slots from `from` on.
  template <class Visit>
  HOST_DEVICE void visit_cell(int k, const IVec3& cell, int from, Visit&& visit) const {
    const int place = grids.grid[k].index(cell);
    const Span<const int> at = offsets_of(k);
    visit(SlotRange{at[place] < from ? from : at[place], at[place + 1], grids.grid[k].tag(cell)});
  }

  HOST_DEVICE Span<const int> offsets_of(int k) const {
    return {offsets.data() + grids.first_place[k], offsets.size() - grids.first_place[k]};
  }

  /// In a dense grid with a border: the cell from slot `from` on and the cell after it, then the rows above. Tags are
  /// compared here too where another class's cells are hashed.
  template <class Visit>
  HOST_DEVICE void visit_half_of_dense(int k, const IVec3& cell, int from, Visit&& visit) const {
    const Grid<V>& grid = grids.grid[k];
    const int* at = offsets.data() + grids.first_place[k] + grid.index(cell);
    const int row = grid.cells.x, layer = row * grid.cells.y;
    const unsigned tag = grid.row(cell.y, cell.z);
    visit(SlotRange{from, at[2], tag});
    visit(SlotRange{at[row - 1], at[row + 2], tag + 1});
    if constexpr (kDimensions<V> == 3) {
      for (int y = -1; y <= 1; ++y) {
        const int r = layer + y * row;
        visit(SlotRange{at[r - 1], at[r + 2], tag + unsigned(grid.cells.y + y)});
      }
    }
  }

  /// The same where places wrap around.
  template <class Visit>
  HOST_DEVICE void visit_half_of_hashed(int k, const IVec3& c, int from, Visit&& visit) const {
    const Grid<V>& grid = grids.grid[k];
    const unsigned row = grid.row(c.y, c.z);
    const unsigned start = grid.row_place(row);
    const int own = grid.place(start, c.x), next = grid.place(start, c.x + 1);
    const Span<const int> at = offsets_of(k);
    visit(SlotRange{from, at[(next < own ? own : next) + 1], row});
    if (next < own) visit(SlotRange{at[next], at[next + 1], row});
    visit_row(k, c.y + 1, c.z, c.x - 1, c.x + 1, visit);
    if constexpr (kDimensions<V> == 3) {
      for (int y = c.y - 1; y <= c.y + 1; ++y) visit_row(k, y, c.z + 1, c.x - 1, c.x + 1, visit);
    }
  }

  template <class Visit>
  HOST_DEVICE void visit_all_neighbours(int k, const V& p, int slot, Visit&& visit) const {
    grids.grid[k].for_each_neighbour(grids.grid[k].cell_of(p), [&](const IVec3& cell) {
      visit_cell(k, cell, slot + 1, visit);
      return true;
    });
  }

  /// Visits the cells of class k that hold centres of spheres which may touch the sphere at p.
  template <class Visit>
  HOST_DEVICE void visit_reach(int k, const V& p, Real radius, Visit&& visit) const {
    const Grid<V>& grid = grids.grid[k];
    const Real reach = (radius + grids.largest[k]) * Real(1.000001) + grids.guard;
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int axis = 0; axis < kDimensions<V>; ++axis) reached_cells(grid, axis, p[axis], reach, low[axis], high[axis]);
    // To look up more rows than there are spheres, whose places are bounded in number, would take longer than to test all.
    const Span<const int> at = offsets_of(k);
    const int first = at[0], last = at[grid.size()];
    double lookups = (double(high[1]) - low[1] + 1) * (double(high[2]) - low[2] + 1);
    if (grid.is_periodic) lookups *= double(high[0]) - low[0] + 1;
    if (lookups > double(last - first)) {
      visit(SlotRange{first, last, 0, true});
      return;
    }
    for (int z = low[2]; z <= high[2]; ++z) {
      for (int y = low[1]; y <= high[1]; ++y) {
        if (!grid.is_periodic) {
          visit_row(k, y, z, low[0], high[0], visit);
          continue;
        }
        for (int x = low[0]; x <= high[0]; ++x) {
          visit_cell(k, IVec3(grid.wrapped(0, x), grid.wrapped(1, y), grid.wrapped(2, z)), 0, visit);
        }
      }
    }
  }

  /// The cells within `reach` of p along an axis; in periodic domains each once, to be wrapped.
  HOST_DEVICE static void reached_cells(const Grid<V>& grid, int axis, Real p, Real reach, int& low, int& high) {
    if (!grid.is_periodic) {
      low = grid.coordinate_of(p - reach, axis);
      high = grid.coordinate_of(p + reach, axis);
      return;
    }
    low = int(std::floor((p - reach - grid.origin[axis]) * grid.inverse_edge[axis]));
    high = int(std::floor((p + reach - grid.origin[axis]) * grid.inverse_edge[axis]));
    if (high - low >= grid.cells[axis]) {
      low = 0;
      high = grid.cells[axis] - 1;
    }
  }
};

template <class V, class Exec>
class SortedGrid {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  explicit SortedGrid(const BroadPhaseParameters<V>& parameters) {
    std::vector<SizeClass<V>> classes = parameters.classes;
    if (parameters.cell_size && !classes.empty()) classes = {{parameters.largest_radius(), parameters.count}};
    grids_.guard = static_cast<Scalar<V>>(rounding_guard(parameters.box));
    for (const SizeClass<V>& spheres : classes) {
      const int k = grids_.count++;
      grids_.largest[k] = spheres.largest;
      grids_.first_place[k] = static_cast<int>(places_);
      const double edge = wanted_edge(parameters, spheres);
      grids_.grid[k] = make_grid(parameters, spheres, edge, is_hashed(parameters, spheres, edge));
      if (!grids_.grid[k].is_hashed && !grids_.grid[k].is_periodic) grids_.grid[k] = with_border(grids_.grid[k]);
      places_ += grids_.grid[k].size();
      is_hashed_ |= grids_.grid[k].is_hashed;
    }
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    offsets_.resize(places_ + 1);
    slots_.resize(bodies.size());
    exec.bin("sort by cell", PlaceOfBody<V>{grids_, bodies.position, bodies.radius}, offsets_.span(), slots_.body());
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
      const int first = offsets[static_cast<size_t>(grids_.first_place[k])];
      const int last = offsets[static_cast<size_t>(grids_.first_place[k] + grids_.grid[k].size())];
      const auto listed = list_cells(grids_.grid[k], position, {body.begin() + first, body.begin() + last});
      if (listed) result.push_back(*listed);
    }
    return result;
  }

  int64_t bytes() const { return slots_.bytes() + offsets_.bytes() + tag_.bytes(); }

 private:
  // Two spheres a cell: a vector holds what a row of cells does, and there are fewer rows to look up. Where the spheres
  // may gather anywhere, cells of twice the volume of the smallest allowed hold about two in the densest heap.
  static constexpr double kPerCell = 2;
  static constexpr double kEdgeOfHeaps = 1.25;
  // Beyond that, reading and writing the offsets of empty cells costs more than checking tags.
  static constexpr double kDenseCellsPerBody = 6;

  static double wanted_edge(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres) {
    const double diameter = 2 * double(spheres.largest);
    if (parameters.occupied_volume == 0) return kEdgeOfHeaps * diameter;
    const double volume = kPerCell * parameters.occupied_volume / double(spheres.count);
    return std::max(diameter, std::pow(volume, 1.0 / kDimensions<V>));
  }

  static bool is_hashed(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres, double edge) {
    if (parameters.table != CellTable::automatic) return parameters.table == CellTable::hashed;
    return !parameters.cell_size && cell_count(parameters.box, edge) > kDenseCellsPerBody * double(spheres.count) + 4096;
  }

  ClassGrids<V> grids_;
  int64_t places_ = 0;
  bool is_hashed_ = false;
  Slots<V, Exec> slots_;
  Buffer<int> offsets_;
  Buffer<unsigned> tag_;
};

}  // namespace ballpit
