// SPDX-License-Identifier: MIT
// Sort and sweep as on slides 2 to 4: one list of begins and ends, sorted by coordinate; one thread per entry, which walks
// the list. The tuned method, whose threads do not walk: broad_phase/sort_and_sweep.h.
#pragma once

#include <cmath>

#include "lecture/memory.h"
#include "lecture/spheres.h"

namespace ballpit::lecture {

template <class V, class Memory>
struct SortAndSweep {
  Memory memory;
  Spheres<V> spheres;
  PairSink contacts;
  Span<int> list;      // 2i is the begin of sphere i, 2i + 1 its end
  int axis;            // 0, 1, 2: x, y, z
  Scalar<V> guard;     // by which intervals are longer than spheres, against rounding [m]
  bool is_narrow;      // periodic, and so short that two spheres may meet on both sides: all pairs are tested

  HOST_DEVICE static int sphere_of(int entry) { return entry / 2; }
  HOST_DEVICE static bool is_end(int entry) { return entry % 2 == 1; }
  HOST_DEVICE int after(int k) const { return k + 1 < list.size() ? k + 1 : 0; }

  /// Slide 2: the projection of a sphere's left or right edge.
  HOST_DEVICE float coordinate(int entry) const {
    const int i = sphere_of(entry);
    V edge = spheres.position[i];
    const Scalar<V> reach = spheres.radius[i] + guard;
    edge[axis] += is_end(entry) ? reach : -reach;
    return static_cast<float>(spheres.box.wrap(edge)[axis]);
  }

  /// Slides 2 and 3: one thread per sphere puts its begin and its end into the common list. Begins come first, so that
  /// after a stable sort spheres that touch exactly are found.
  HOST_DEVICE void store_entries(int i) const {
    memory.store(&list[i], 2 * i);
    memory.store(&list[spheres.size() + i], 2 * i + 1);
  }

  /// Slide 3: sorts the list by coordinate. One thread, by insertion; large lists are sorted by a radix sort instead.
  HOST_DEVICE void sort(int) const {
    for (int k = 1; k < list.size(); ++k) {
      const int moved = memory.load(&list[k]);
      int at = k;
      for (; at > 0 && coordinate(list[at - 1]) > coordinate(moved); --at) memory.store(&list[at], list[at - 1]);
      if (at < k) memory.store(&list[at], moved);
    }
  }

  /// Slide 4: one thread per entry of the sorted list.
  HOST_DEVICE Work collide(int t) const {
    Work work;
    const int own = memory.load(&list[t]);
    if (is_end(own)) return work;                   // an end terminates
    for (int k = after(t); k != t; k = after(k)) {  // a begin walks the list …
      const int other = memory.load(&list[k]);
      ++work.steps;
      if (other == own + 1 && !is_narrow) break;  // … to its own end
      if (is_end(other) || (is_narrow && other < own)) continue;
      ++work.tests;  // … and tests every other begin
      const int i = sphere_of(own), j = sphere_of(other);
      if (memory.test(i, j, spheres.touch(i, j))) memory.append(contacts, i, j);
    }
    return work;
  }
};

}  // namespace ballpit::lecture
