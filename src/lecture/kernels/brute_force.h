// SPDX-License-Identifier: MIT
// Brute force as on slide 5: every pair is tested, O(n²). The tuned method: broad_phase/brute_force.h.
#pragma once

#include "lecture/kernels/memory.h"
#include "lecture/kernels/spheres.h"

namespace ballpit::lecture {

template <class V, class Memory>
struct BruteForce {
  Memory memory;
  Spheres<V> spheres;
  PairSink contacts;

  // One thread per sphere i tests all spheres after it (slide 5).
  HOST_DEVICE Work collide(int i) const {
    Work work;
    for (int j = i + 1; j < spheres.size(); ++j) {
      work.count_step();
      work.count_test();
      const bool touch = memory.test(i, j, spheres.touch(i, j));
      if (touch) memory.append(contacts, i, j);
    }
    return work;
  }
};

}  // namespace ballpit::lecture
