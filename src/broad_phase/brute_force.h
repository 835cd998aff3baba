// SPDX-License-Identifier: MIT
// Brute force: every pair is a candidate, once.
//
//          j 0 1 2 3
//     i 0    · x x x      thread i tests all j > i: one range of slots, in the order of the bodies
//       1    · · x x
//       2    · · · x      cost: n(n−1)/2 tests, no data structure; exact, so the other methods are tested against it
//       3    · · · ·
//
// Source: slides 5 and 6. Siblings: sort_and_sweep.h, linked_cell.h, sorted_grid.h.
#pragma once

#include "bodies/bodies_view.h"
#include "bodies/slots.h"
#include "broad_phase/inspection.h"
#include "broad_phase/parameters.h"

namespace ballpit {

template <class V>
struct BruteForceCandidates {
  SlotsView<V> slots_view;

  HOST_DEVICE const SlotsView<V>& slots() const { return slots_view; }
  HOST_DEVICE int threads() const { return slots_view.count; }
  HOST_DEVICE int slot_of(int thread) const { return thread; }

  template <class Visit>
  HOST_DEVICE void for_each_range(int slot, Visit&& visit) const {
    visit(SlotRange{slot + 1, slots_view.count});
  }

  /// Tile by tile, so that all slots from … to − 1 test a tile while it is in the cache.
  template <class Visit>
  void for_each_range_of(int from, int to, Visit&& visit) const {
    for (int tile = from + 1; tile < slots_view.count; tile += kTile) {
      const int end = slots_view.count - tile < kTile ? slots_view.count : tile + kTile;
      for (int slot = from; slot < to; ++slot) visit(slot, SlotRange{slot < tile ? tile : slot + 1, end});
    }
  }

 private:
  static constexpr int kTile = 1024;  // slots
};

/// Kernel: slot i holds body i.
struct KeepOrder {
  Span<int> body;
  HOST_DEVICE void operator()(int slot) const { body[slot] = slot; }
};

template <class V, class Exec>
class BruteForce {
 public:
  explicit BruteForce(const BroadPhaseParameters<V>&) {}
  void plan(const BroadPhaseParameters<V>&) {}

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    slots_.resize(bodies.size());
    exec.parallel_for("keep order", bodies.size(), KeepOrder{slots_.body()});
    slots_.gather(exec, bodies.position, bodies.radius);
  }
  BruteForceCandidates<V> candidates() const { return {slots_.view()}; }
  std::vector<GridInspection> inspect(Exec&) const { return {}; }
  int64_t bytes() const { return slots_.bytes(); }

 private:
  Slots<V, Exec> slots_;
};

}  // namespace ballpit
