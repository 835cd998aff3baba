// SPDX-License-Identifier: MIT
// Brute force as on slide 5: every pair is tested, O(n²). The tuned method: broad_phase/brute_force.h.
#pragma once

#include "lecture/memory.h"
#include "lecture/spheres.h"

namespace ballpit::lecture {

template <class V, class Memory>
struct BruteForce {
  Memory memory;
  Spheres<V> spheres;
  PairSink contacts;

  /// Slide 5: one thread per sphere, which tests all spheres after it.
  HOST_DEVICE Work collide(int i) const {
    Work work;
    for (int j = i + 1; j < spheres.size(); ++j) {
      ++work.tests, ++work.steps;
      if (memory.test(i, j, spheres.touch(i, j))) memory.append(contacts, i, j);
    }
    return work;
  }
};

}  // namespace ballpit::lecture
