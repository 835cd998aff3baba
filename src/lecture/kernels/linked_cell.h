// SPDX-License-Identifier: MIT
// Linked cells as on slides 8 to 17: a grid whose cells are linked lists in two arrays. The tuned method:
// broad_phase/linked_cell.h.
#pragma once

#include <cmath>

#include "broad_phase/grid.h"
#include "lecture/kernels/memory.h"
#include "lecture/kernels/mistakes.h"
#include "lecture/kernels/spheres.h"

namespace ballpit::lecture {

template <class V, class Memory>
struct LinkedCell {
  Memory memory;
  Spheres<V> spheres;
  PairSink contacts;
  Grid<V> grid;
  Span<int> head;  // for each cell its first particle, or −1 (slide 12)
  Span<int> next;  // for each particle the next in its cell, or −1
  Mistakes mistakes;

  // ⌊x⌋ along one axis, with x in cells (slide 9).
  HOST_DEVICE int floor(Scalar<V> p, int axis) const {
    const auto x = (p - grid.origin[axis]) * grid.inverse_edge[axis];
    const auto n = Scalar<V>(grid.cells[axis]);
    auto c = mistakes.truncates ? to_int(p, grid, axis) : std::floor(x);
    if (grid.is_periodic) c -= n * std::floor(c / n);
    return c > 0 ? (c < n ? int(c) : grid.cells[axis] - 1) : 0;
  }
  HOST_DEVICE IVec3 cell_of(const V& p) const {
    IVec3 cell(0);
    for (int k = 0; k < kDimensions<V>; ++k) cell[k] = floor(p[k], k);
    return cell;
  }

  // ⌊y⌋·Nx + ⌊x⌋, in space (⌊z⌋·Ny + ⌊y⌋)·Nx + ⌊x⌋ (slide 9).
  HOST_DEVICE int hash(const IVec3& cell) const {
    return (cell.z * grid.cells.y + cell.y) * grid.cells.x + cell.x;
  }

  // One thread per cell (slide 13).
  HOST_DEVICE void clear(int cell) const {
    memory.store(&head[cell], -1);
  }

  // One thread per particle i: entries are exchanged (slides 14, 15).
  HOST_DEVICE void insert(int i) const {
    const V p = spheres.position[i];
    const int cell = memory.value(hash(cell_of(p)));    // slide 9
    const int old = memory.atomicExch(&head[cell], i);  // slide 17
    memory.store(&next[i], old);
  }

  // The same without an atomic operation: a race (slide 16).
  HOST_DEVICE void insert_racing(int i) const {
    const V p = spheres.position[i];
    const int cell = memory.value(hash(cell_of(p)));
    const int old = memory.load_shared(&head[cell]);
    memory.store_shared(&head[cell], i);  // another may have stored
    memory.store(&next[i], old);
  }

  // One thread per particle i visits 3 × 3 (× 3) cells (slide 10).
  HOST_DEVICE Work collide(int i) const {
    Work work;
    const IVec3 own = cell_of(spheres.position[i]);
    grid.for_each_neighbour(own, [&](const IVec3& cell) {
      if (mistakes.leave_out(own, cell)) return true;
      int j = memory.load(&head[hash(cell)]);
      for (; j != -1; j = memory.load(&next[j])) {
        work.count_step();
        if (mistakes.tests_twice ? j == i : j <= i) continue;
        work.count_test();  // each pair once: only j > i
        const bool touch = memory.test(i, j, spheres.touch(i, j));
        if (touch) memory.append(contacts, i, j);
      }
      return true;
    });
    return work;
  }
};

}  // namespace ballpit::lecture
