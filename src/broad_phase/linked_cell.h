// SPDX-License-Identifier: MIT
// Linked cells: a grid whose cells are linked lists in two arrays, built by all threads in parallel (slides 12 to 17).
//
//     cell   0   1   2   3   4   5           head[cell]: the body linked last, −1 where the cell is empty
//     head  −1  −1  −1  −1   2  −1
//                            │
//     body   0   1   2 ◀─────┘   4   5   6   next[body]: the body linked before it in the same cell, or −1
//     next           6 ──────────────────▶ −1
//
// Link: next[body] = atomic exchange(head[cell], body). The exchange returns each old entry to exactly one thread, so
// no body is lost, however many threads insert into one cell. The order within a cell list depends on the threads; the
// contacts are sorted afterwards.
//
// A single thread links bodies in the order of their indices, so its cell lists are in descending order, and a search
// for j > i can stop early.
//
// Cost: O(n + cells) to build, then for each body the lists of its 3 × 3 (× 3) block: O(n) while cells hold O(1)
// bodies. Memory: 4 bytes a cell, 4 bytes a body. Each pair is visited only from its lower index. In a hashed grid a
// list may hold bodies of several cells; their positions show which ones belong to the wanted cell.
// Source: slides 8 to 17; Green, "Particle simulation using CUDA" (2010). Sibling with its cells sorted: sorted_grid.h.
#pragma once

#include <numeric>

#include "bodies/bodies_view.h"
#include "broad_phase/grid.h"
#include "exec/atomics.h"

namespace ballpit {

/// Kernel: puts body i into its cell.
template <class V>
struct LinkBody {
  Grid<V> grid;
  Span<const V> position;
  Span<int> head;
  Span<int> next;

  HOST_DEVICE void operator()(int i) const {
    next[i] = atomic_exchange(&head[grid.index(grid.cell_of(position[i]))], i);
  }
};

template <class V>
struct LinkedCellCandidates {
  Grid<V> grid;
  Span<const V> position;
  Span<const int> head;
  Span<const int> next;
  bool is_descending = false;  ///< whether the indices of each list are in descending order

  /// Calls visit(j) for each j > i in the block around i's cell, until visit returns false.
  template <class Visit>
  HOST_DEVICE void for_each(int i, Visit&& visit) const {
    if (kOnDevice || grid.is_hashed) {
      walk_lists(i, visit);
    } else {
      walk_lists_in_batches(i, visit);
    }
  }

 private:
  static constexpr int kBatch = 32;

  /// For CPUs, where mispredicted branches are expensive and the arrays lie in a cache.
  template <class Visit>
  HOST_DEVICE void walk_lists_in_batches(int i, Visit&& visit) const {
    const int end = is_descending ? i : -1;  // a list ends at the first index up to this one
    // First collect the lists, without a branch for each cell: whether a cell is empty is hard to predict.
    int starts[kDimensions<V> == 3 ? 27 : 9];
    int lists = 0;
    grid.for_each_neighbour(grid.cell_of(position[i]), [&](const IVec3& cell) {
      starts[lists] = head[grid.index(cell)];
      lists += starts[lists] > end;
      return true;
    });
    // Then collect their bodies with a higher index, without a branch for each body.
    int higher[kBatch];
    int count = 0;
    for (int k = 0; k < lists; ++k) {
      for (int j = starts[k]; j > end; j = next[j]) {
        higher[count] = j;
        count += j > i;
        if (count == kBatch && !visit_all(higher, count, visit)) return;
      }
    }
    visit_all(higher, count, visit);
  }

  template <class Visit>
  HOST_DEVICE void walk_lists(int i, Visit&& visit) const {
    grid.for_each_neighbour(grid.cell_of(position[i]), [&](const IVec3& cell) {
      for (int j = head[grid.index(cell)]; j != -1; j = next[j]) {
        if (j > i && (!grid.is_hashed || grid.cell_of(position[j]) == cell) && !visit(j)) return false;
      }
      return true;
    });
  }

  /// Empties the batch; false if a visit returned false.
  template <class Visit>
  HOST_DEVICE static bool visit_all(const int* bodies, int& count, Visit&& visit) {
    for (int k = 0; k < count; ++k) {
      if (!visit(bodies[k])) return false;
    }
    count = 0;
    return true;
  }
};

template <class V, class Exec>
class LinkedCell {
 public:
  explicit LinkedCell(const BroadPhaseParameters<V>& parameters) { plan(parameters); }

  void plan(const BroadPhaseParameters<V>& parameters) {
    grid_ = make_grid(parameters, SizeClass<V>{parameters.largest_radius(), parameters.count},
                      V(2 * parameters.largest_radius()), parameters.table == CellTable::hashed);
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    head_.resize(grid_.size());
    next_.resize(bodies.size());
    position_ = bodies.position;
    exec.fill("clear cells", head_.span(), -1);
    is_descending_ = exec.runs_in_order();
    exec.parallel_for("link bodies", bodies.size(), LinkBody<V>{grid_, position_, head_.span(), next_.span()});
  }

  LinkedCellCandidates<V> candidates() const { return {grid_, position_, head_.span(), next_.span(), is_descending_}; }

  std::vector<GridInspection> inspect(Exec& exec) const {
    if (grid_.is_hashed) {
      std::vector<int> bodies(static_cast<size_t>(next_.size()));
      std::iota(bodies.begin(), bodies.end(), 0);
      GridInspection result = list_cells(grid_, exec.download(position_), bodies);
      result.arrays = CellArrays{false, true, exec.download(head_.span()), exec.download(next_.span())};
      return {result};
    }
    GridInspection result = describe_grid(grid_);
    result.head = exec.download(head_.span());
    result.next = exec.download(next_.span());
    return {result};
  }

  int64_t bytes() const { return head_.bytes() + next_.bytes(); }

 private:
  Grid<V> grid_;
  Span<const V> position_;
  bool is_descending_ = false;
  typename Exec::template Buffer<int> head_, next_;
};

}  // namespace ballpit
