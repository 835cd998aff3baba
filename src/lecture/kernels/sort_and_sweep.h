// SPDX-License-Identifier: MIT
// Sort and sweep as on slides 2 to 4: one list of begins and ends, sorted by coordinate; one thread per entry, which
// walks the list. The tuned method, whose threads do not walk: broad_phase/sort_and_sweep.h.
#pragma once

#include "lecture/kernels/memory.h"
#include "lecture/kernels/spheres.h"

namespace ballpit::lecture {

template <class V, class Memory>
struct SortAndSweep {
  Memory memory;
  Spheres<V> spheres;
  PairSink contacts;
  Span<int> list;   // entry 2i: begin of sphere i, 2i + 1: its end
  int axis;         // 0, 1, 2: x, y, z
  Scalar<V> guard;  // [m] against rounding: intervals are longer by it
  bool
      tests_all;  // in a domain so narrow that spheres may touch on both sides

  HOST_DEVICE static int sphere_of(int entry) { return entry / 2; }
  HOST_DEVICE static bool is_end(int entry) { return entry % 2 == 1; }
  HOST_DEVICE int after(int k) const {
    return k + 1 < list.size() ? k + 1 : 0;
  }

  // The left or the right edge of a sphere, on the axis (slide 2).
  HOST_DEVICE float coordinate(int entry) const {
    V edge = spheres.position[sphere_of(entry)];
    const Scalar<V> reach = spheres.radius[sphere_of(entry)] + guard;
    edge[axis] += is_end(entry) ? reach : -reach;
    return static_cast<float>(spheres.box.wrap(edge)[axis]);
  }

  // One thread per sphere i: a begin and an end (slides 2 and 3).
  // Begins are first, and stay so at equal coordinates.
  HOST_DEVICE void store_entries(int i) const {
    memory.store(&list[i], 2 * i);
    memory.store(&list[spheres.size() + i], 2 * i + 1);
  }

  // One thread sorts the list by insertion (slide 3).
  // Long lists are sorted by radix instead.
  HOST_DEVICE void sort(int) const {
    for (int k = 1; k < list.size(); ++k) {
      const int moved = memory.load(&list[k]);
      int at = k;
      while (at > 0 && coordinate(list[at - 1]) > coordinate(moved)) {
        memory.store(&list[at], list[at - 1]);
        --at;
      }
      if (at < k) memory.store(&list[at], moved);
    }
  }

  // One thread per entry t of the sorted list (slide 4).
  HOST_DEVICE Work collide(int t) const {
    Work work;
    const int own = memory.load(&list[t]);
    if (is_end(own)) return work;  // an end stops
    // A begin walks to its own end, and tests every other begin.
    for (int k = after(t); k != t; k = after(k)) {
      const int other = memory.load(&list[k]);
      work.count_step();
      if (other == own + 1 && !tests_all) break;
      if (is_end(other) || (tests_all && other < own)) continue;
      work.count_test();
      const int i = sphere_of(own), j = sphere_of(other);
      const bool touch = memory.test(i, j, spheres.touch(i, j));
      if (touch) memory.append(contacts, i, j);
    }
    return work;
  }
};

}  // namespace ballpit::lecture
