// SPDX-License-Identifier: MIT
// Brute force: every pair is a candidate, once.
//
//          j 0 1 2 3
//     i 0    · x x x      thread i tests all j > i
//       1    · · x x
//       2    · · · x      cost: n(n−1)/2 tests, no memory; exact by construction, and so the oracle of the others
//       3    · · · ·
//
// Source: slides 5 and 6. Sibling: linked_cell.h.
#pragma once

#include "simulate/broadphase/parameters.h"
#include "simulate/state.h"

namespace ballpit {

struct BruteForceCandidates {
  int count;

  /// Calls visit(j) for each j > i.
  template <class Visit>
  HOST_DEVICE void for_each(int i, Visit&& visit) const {
    for (int j = i + 1; j < count; ++j) {
      if (!visit(j)) return;
    }
  }
};

template <class V, class Exec>
class BruteForce {
 public:
  BruteForce(const BroadPhaseParameters<V>&) {}

  void prepare(Exec&, const BodiesView<V>& bodies) { count_ = static_cast<int>(bodies.size()); }
  BruteForceCandidates candidates() const { return {count_}; }
  std::optional<GridInspection> inspect(Exec&) const { return std::nullopt; }

 private:
  int count_ = 0;
};

}  // namespace ballpit
