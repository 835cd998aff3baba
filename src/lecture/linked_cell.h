// SPDX-License-Identifier: MIT
// Linked cells as on slides 8 to 17: a grid whose cells are linked lists in two arrays. The tuned method:
// broad_phase/linked_cell.h.
#pragma once

#include <cmath>

#include "broad_phase/grid.h"
#include "lecture/memory.h"
#include "lecture/spheres.h"

namespace ballpit::lecture {

/// Mistakes that students make, each a switch. They cost pairs: docs/lecture.md shows which.
struct Mistakes {
  bool truncates = false;      ///< int() for floor: −0.5 belongs to cell 0
  bool forgets_wrap = false;   ///< no cells beyond a periodic border
  bool tests_twice = false;    ///< both halves of a pair: (i, j) and (j, i)
};

template <class V, class Memory>
struct LinkedCell {
  Memory memory;
  Spheres<V> spheres;
  PairSink contacts;
  Grid<V> grid;
  Span<int> head;  // slide 12, cells: the first particle of each cell, or −1
  Span<int> next;  // slide 12, particles: the next particle of the same cell, or −1
  Mistakes mistakes;

  /// Slide 9: the cell's column, row or layer, ⌊x⌋ with x in cells. Beyond the border it is the cell at the border, or in
  /// a periodic domain the one on the other side.
  HOST_DEVICE int floor(Scalar<V> p, int axis) const {
    const Scalar<V> x = (p - grid.origin[axis]) * grid.inverse_edge[axis], n = Scalar<V>(grid.cells[axis]);
    Scalar<V> c = mistakes.truncates ? std::trunc(x) : std::floor(x);
    if (grid.is_periodic) c -= n * std::floor(c / n);
    return c > 0 ? (c < n ? int(c) : grid.cells[axis] - 1) : 0;
  }
  HOST_DEVICE IVec3 cell_of(const V& p) const {
    IVec3 cell(0);
    for (int axis = 0; axis < kDimensions<V>; ++axis) cell[axis] = floor(p[axis], axis);
    return cell;
  }

  /// Slide 9: i = ⌊y⌋·Nx + ⌊x⌋, in space (⌊z⌋·Ny + ⌊y⌋)·Nx + ⌊x⌋.
  HOST_DEVICE int hash(const IVec3& cell) const { return (cell.z * grid.cells.y + cell.y) * grid.cells.x + cell.x; }

  /// Slide 13: one thread per cell.
  HOST_DEVICE void clear(int cell) const { memory.store(&head[cell], -1); }

  /// Slides 14, 15 and 17: one thread per particle.
  HOST_DEVICE void insert(int i) const {
    const int cell = memory.value(hash(cell_of(spheres.position[i])));
    const int old = memory.atomicExch(&head[cell], i);
    memory.store(&next[i], old);
  }

  /// Slide 16: the same without an atomic operation. Two threads may load the same old value; then one particle is lost.
  HOST_DEVICE void insert_racing(int i) const {
    const int cell = memory.value(hash(cell_of(spheres.position[i])));
    const int old = memory.load_shared(&head[cell]);
    memory.store_shared(&head[cell], i);
    memory.store(&next[i], old);
  }

  /// Slide 10: one thread per particle walks the lists of the 3 × 3 (× 3) cells around its own. Each pair is tested once.
  HOST_DEVICE Work collide(int i) const {
    Work work;
    const IVec3 center = cell_of(spheres.position[i]);
    grid.for_each_neighbour(center, [&](const IVec3& cell) {
      if (mistakes.forgets_wrap && is_across_border(center, cell)) return true;
      for (int j = memory.load(&head[hash(cell)]); j != -1; j = memory.load(&next[j])) {
        ++work.steps;
        if (mistakes.tests_twice ? j == i : j <= i) continue;
        ++work.tests;
        if (memory.test(i, j, spheres.touch(i, j))) memory.append(contacts, i, j);
      }
      return true;
    });
    return work;
  }

  HOST_DEVICE static bool is_across_border(const IVec3& a, const IVec3& b) {
    const IVec3 d = a - b;
    return d.x * d.x > 1 || d.y * d.y > 1 || d.z * d.z > 1;
  }
};

}  // namespace ballpit::lecture
