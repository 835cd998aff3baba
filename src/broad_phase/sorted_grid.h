// SPDX-License-Identifier: MIT
// Sorted grid: bodies sorted by their cells, so that a cell is a range of slots, and so are cells in a row.
//
//     cell     0   1   2   3   4   5        slot     0   1   2   3   4
//     offsets  0   0   2   2   3   5  5     body     1   3   0   2   4       cell c holds slots offsets[c] … offsets[c+1]−1
//                  └─── 2 bodies in cell 1: slots 0 and 1
//
//       ┌───┬───┬───┐
//       │ ▒ │ ▒ │ ▒ │   Each pair once: a body looks at the slots after its own in its cell and the next (▓), and at
//       │ ▒ │ ▒ │ ▒ │   the rows of three cells above (▒), which are contiguous: two ranges in the plane, five in
//       ├───┼───┼───┤   space. In periodic domains it looks at all neighbours, at the slots after its own.
//       │   │ ▓ │ ▓ │
//       │   │ ● │ ▓ │   A cell is one diameter long, but so wide that three in a row fill a vector; so a body reaches
//       └───┴───┴───┘   few of the rows above, and the others cost nothing. With --cell-size cells are cubes, and the
//                       block is searched whole, as on slide 16.
//
// Spheres of different sizes: a grid for each size class (a factor of about 2.5), one after the other in the same arrays,
// largest first. A body looks in its own class as above, and in each finer class at the cells that its sphere reaches: a
// large sphere reads long rows of small ones, a small one never reads cells made for large ones. With --cell-size, one grid
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

#include "bodies/bodies_view.h"
#include "bodies/slots.h"
#include "broad_phase/grid.h"
#include "broad_phase/inspection.h"
#include "core/span.h"

namespace ballpit {

/// The grids of all size classes, in one array of cells.
template <class V>
struct ClassGrids {
  using Real = Scalar<V>;
  int count = 0;
  bool is_block = false;                  ///< whether the whole 3 × 3 (× 3) block is searched, and nothing beyond it
  Real guard = 0;                         ///< what rounding may add to a distance [m]
  Real largest[kMaxSizeClasses] = {};     ///< [m] radius, falling
  V diameter[kMaxSizeClasses] = {};       ///< [cells] of the largest, with what rounding may add
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
    const Grid<V>& grid = grids.grid[own];
    if (grid.is_periodic) {
      visit_reach(own, p, radius, slot + 1, visit);
    } else {
      const IVec3 cell = grid.cell_of(p);
      if (grid.is_hashed) {
        visit_half_of_hashed(own, cell, rows_reached(own, p, cell), slot + 1, visit);
      } else {
        visit_half_of_dense(own, grid.index(cell), grid.row(cell.y, cell.z), rows_reached(own, p, cell), slot + 1,
                            visit);
      }
    }
    for (int k = own + 1; k < grids.count; ++k) visit_reach(k, p, radius, 0, visit);
  }

  template <class Visit>
  void for_each_range_of(int from, int to, Visit&& visit) const {
    for (int first = from, last; first < to; first = last) {
      last = to - first < kTogether ? to : first + kTogether;
      const int k = grids.count == 1 ? 0 : grids.class_of(slots_view.radius[first]);
      const int end_of_class = offsets[grids.first_place[k] + grids.grid[k].size()];
      if (end_of_class < last) last = end_of_class;
      if (!grids.grid[k].is_periodic && !grids.grid[k].is_hashed) {
        visit_together(k, first, last, visit);
      } else {
        for (int slot = first; slot < last; ++slot) {
          for_each_range(slot, [&](const SlotRange& range) { visit(slot, range); });
        }
      }
    }
  }

 private:
  static constexpr int kTogether = 64;

  /// Which of the rows beside its own a sphere reaches. All bits are set where it does, so that nobody need ask: the
  /// answers are hard to predict.
  struct Rows {
    int is_up, is_down, is_front;
  };

  HOST_DEVICE Rows rows_reached(int k, const V& p, const IVec3& cell) const {
    const Grid<V>& grid = grids.grid[k];
    const V& diameter = grids.diameter[k];
    const Real y = grid.place_in(cell.y, p[1], 1);
    Rows rows{-int(y > 1 - diameter[1]), -int(y < diameter[1]), 0};
    if constexpr (kDimensions<V> == 3) rows.is_front = -int(grid.place_in(cell.z, p[2], 2) > 1 - diameter[2]);
    return rows;
  }

  /// For slots in a row, all of class k, whose grid is dense: first where each lies, which the compiler turns into vector
  /// instructions, then the ranges of each.
  template <class Visit>
  void visit_together(int k, int first, int last, Visit&& visit) const {
    const Grid<V>& grid = grids.grid[k];
    int place[kTogether], row[kTogether], is_up[kTogether], is_down[kTogether], is_front[kTogether];
    for (int s = 0; s < last - first; ++s) {
      const V p = slots_view.position(first + s);
      const IVec3 cell = grid.cell_of(p);
      const Rows rows = rows_reached(k, p, cell);
      place[s] = grid.index(cell);
      row[s] = static_cast<int>(grid.row(cell.y, cell.z));
      is_up[s] = rows.is_up;
      is_down[s] = rows.is_down;
      is_front[s] = rows.is_front;
    }
    for (int s = 0; s < last - first; ++s) {
      visit_half_of_dense(k, place[s], static_cast<unsigned>(row[s]), {is_up[s], is_down[s], is_front[s]},
                          first + s + 1, [&](const SlotRange& range) { visit(first + s, range); });
    }
    for (int finer = k + 1; finer < grids.count; ++finer) {
      for (int slot = first; slot < last; ++slot) {
        visit_reach(finer, slots_view.position(slot), slots_view.radius[slot], 0,
                    [&](const SlotRange& range) { visit(slot, range); });
      }
    }
  }

  /// Visits what comes after a sphere of class k in a dense grid with a border: slots from `from` on in its cell and the
  /// next, then the rows above. Those out of reach are visited as empty ranges. Tags are compared here too where another
  /// class's cells are hashed.
  template <class Visit>
  HOST_DEVICE void visit_half_of_dense(int k, int place, unsigned tag, const Rows& rows, int from,
                                       Visit&& visit) const {
    const IVec3& cells = grids.grid[k].cells;
    const int* at = offsets.data() + grids.first_place[k] + place;
    visit(SlotRange{from, at[2], tag});
    const auto visit_row_at = [&](int y, int z, int is_reached) {
      const int* row = at + (z * cells.y + y) * cells.x;
      const int first = row[-1], last = row[2];
      visit(SlotRange{first, first + ((last - first) & is_reached), tag + unsigned(z * cells.y + y)});
    };
    visit_row_at(1, 0, rows.is_up);
    if constexpr (kDimensions<V> == 3) {
      visit_row_at(-1, 1, rows.is_front & rows.is_down);
      visit_row_at(0, 1, rows.is_front);
      visit_row_at(1, 1, rows.is_front & rows.is_up);
    }
  }

  /// The same where places wrap around.
  template <class Visit>
  HOST_DEVICE void visit_half_of_hashed(int k, const IVec3& cell, const Rows& rows, int from, Visit&& visit) const {
    visit_row(k, cell.y, cell.z, cell.x, cell.x + 1, from, visit);
    const auto visit_row_at = [&](int y, int z, int is_reached) {
      if (is_reached) visit_row(k, cell.y + y, cell.z + z, cell.x - 1, cell.x + 1, 0, visit);
    };
    visit_row_at(1, 0, rows.is_up);
    if constexpr (kDimensions<V> == 3) {
      visit_row_at(-1, 1, rows.is_front & rows.is_down);
      visit_row_at(0, 1, rows.is_front);
      visit_row_at(1, 1, rows.is_front & rows.is_up);
    }
  }

  /// The first and last cells of class k that may hold the centre of a sphere that touches one at p; in periodic domains
  /// each once, to be wrapped.
  HOST_DEVICE void find_reach(int k, const V& p, Real radius, IVec3& low, IVec3& high) const {
    const Grid<V>& grid = grids.grid[k];
    const Real reach = (radius + grids.largest[k]) * Real(1.000001) + grids.guard;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      if (grids.is_block) {
        grid.neighbours(axis, grid.coordinate_of(p[axis], axis), low[axis], high[axis]);
      } else if (!grid.is_periodic) {
        low[axis] = grid.coordinate_of(p[axis] - reach, axis);
        high[axis] = grid.coordinate_of(p[axis] + reach, axis);
      } else {
        // Compared before they become integers: nothing is outside the grid then, not even from NaN or far away.
        const Real cells = Real(grid.cells[axis]);
        const Real first = std::floor((p[axis] - reach - grid.origin[axis]) * grid.inverse_edge[axis]);
        const Real last = std::floor((p[axis] + reach - grid.origin[axis]) * grid.inverse_edge[axis]);
        const bool is_part = first >= -cells && last < 2 * cells && last - first < cells;
        low[axis] = is_part ? int(first) : 0;
        high[axis] = is_part ? int(last) : grid.cells[axis] - 1;
      }
    }
  }

  /// Visits cells x0 … x1 of a row of an unbounded grid: in one range, or in two where the places wrap around; of the first
  /// cell the slots from `from` on.
  template <class Visit>
  HOST_DEVICE void visit_row(int k, int y, int z, int x0, int x1, int from, Visit&& visit) const {
    const Grid<V>& grid = grids.grid[k];
    const unsigned row = grid.row(y, z);
    const unsigned start = grid.row_place(row);
    const bool is_whole = grid.is_hashed && x1 - x0 >= int(grid.mask);
    const int first = is_whole ? 0 : grid.place(start, x0), last = is_whole ? int(grid.mask) : grid.place(start, x1);
    const Span<const int> at = offsets_of(k);
    const int begin = from > 0 ? from : at[first];
    visit(SlotRange{begin, at[first <= last ? last + 1 : int(grid.mask) + 1], row});
    if (first > last) visit(SlotRange{at[0], at[last + 1], row});
  }

  HOST_DEVICE Span<const int> offsets_of(int k) const {
    return {offsets.data() + grids.first_place[k], offsets.size() - grids.first_place[k]};
  }

  /// Visits the cells of class k that a sphere reaches: slots from `from` on.
  template <class Visit>
  HOST_DEVICE void visit_reach(int k, const V& p, Real radius, int from, Visit&& visit) const {
    const Grid<V>& grid = grids.grid[k];
    IVec3 low(0), high(0);
    find_reach(k, p, radius, low, high);
    // To look up more rows than there are spheres, whose places are bounded in number, would take longer than to test all.
    const Span<const int> at = offsets_of(k);
    const int first = at[0], last = at[grid.size()];
    double lookups = (double(high.y) - low.y + 1) * (double(high.z) - low.z + 1);
    if (grid.is_periodic) lookups *= double(high.x) - low.x + 1;
    if (lookups > double(last - first)) {
      visit(SlotRange{first < from ? from : first, last, kAnyTag});
      return;
    }
    for (int z = low.z; z <= high.z; ++z) {
      for (int y = low.y; y <= high.y; ++y) {
        if (!grid.is_periodic) {
          visit_row(k, y, z, low.x, high.x, 0, visit);
          continue;
        }
        for (int x = low.x; x <= high.x; ++x) {
          const IVec3 cell(grid.wrapped(0, x), grid.wrapped(1, y), grid.wrapped(2, z));
          const int place = grid.index(cell);
          visit(SlotRange{at[place] < from ? from : at[place], at[place + 1], grid.tag(cell)});
        }
      }
    }
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
    places_ = 0;
    is_hashed_ = false;
    std::vector<SizeClass<V>> classes = parameters.classes;
    if (parameters.cell_size && !classes.empty()) classes = {{parameters.largest_radius(), parameters.count}};
    grids_.guard = static_cast<Scalar<V>>(rounding_guard(parameters.box));
    grids_.is_block = parameters.cell_size.has_value();
    for (const SizeClass<V>& spheres : classes) {
      const int k = grids_.count++;
      grids_.largest[k] = spheres.largest;
      grids_.first_place[k] = static_cast<int>(places_);
      const V edge = wanted_edge(parameters, spheres);
      Grid<V>& grid = grids_.grid[k] = make_grid(parameters, spheres, edge, is_hashed(parameters, spheres, edge));
      grids_.diameter[k] = diameter_in(grid, spheres);
      if (!grid.is_hashed && !grid.is_periodic) grid = with_border(grid);
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
      const std::vector<int> bodies(body.begin() + first, body.begin() + last);
      result.push_back(list_cells(grids_.grid[k], position, bodies));
      result.back().arrays =
          CellArrays{true, grids_.grid[k].is_hashed, begins(k, result.back().cells, offsets), bodies};
    }
    return result;
  }

  int64_t bytes() const { return slots_.bytes() + offsets_.bytes() + tag_.bytes(); }

 private:
  /// Where the ranges of a size class begin among its bodies, and where they end: of all places, or of all cells without
  /// the border's, which are empty.
  std::vector<int> begins(int k, const IVec3& cells, const std::vector<int>& offsets) const {
    const Grid<V>& grid = grids_.grid[k];
    const auto first = offsets.begin() + grids_.first_place[k], end = first + grid.size();
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

  // Spheres in what is read of a row, three cells: about those that a vector holds.
  static constexpr double kPerRow = 10;
  // Spheres a diameter cubed (squared) where they lie in a heap.
  static constexpr double kHeap = kDimensions<V> == 3 ? 1.15 : 1.05;
  // Beyond that, reading and writing the offsets of empty cells costs more than checking tags.
  static constexpr double kDenseCellsPerBody = 16;

  static V wanted_edge(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres) {
    const double length = 2 * double(spheres.largest);
    const double density = parameters.occupied_volume > 0 ? double(spheres.count) / parameters.occupied_volume
                                                          : kHeap / std::pow(length, kDimensions<V>);
    const double section = kPerRow / (3 * length * density);
    V edge(static_cast<Scalar<V>>(std::max(length, std::pow(section, 1.0 / (kDimensions<V> - 1)))));
    edge.x = static_cast<Scalar<V>>(length);
    return edge;
  }

  /// How many cells the largest sphere's diameter measures, or with --cell-size more than it ever does.
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
           cell_count(parameters.box, edge) > kDenseCellsPerBody * double(spheres.count) + 4096;
  }

  ClassGrids<V> grids_;
  int64_t places_ = 0;
  bool is_hashed_ = false;
  Slots<V, Exec> slots_;
  Buffer<int> offsets_;
  Buffer<unsigned> tag_;
};

}  // namespace ballpit
