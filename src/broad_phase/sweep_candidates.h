// SPDX-License-Identifier: MIT
// The candidates that sort-and-sweep finds in its sorted list (sort_and_sweep.h): for each begin the slots up to its
// end.
//
//     list    b0  b2  e0  b1  e2  e1      begins_before_end  of body 0: 2, 1: 3, 2: 3
//     slot     0   1       2              candidates         slot 0: [1, 2)   slot 1: [2, 3)   slot 2: none
//
// In a periodic domain an interval that crosses the border continues at the start of the list: a second range [0, k),
// found by binary search. Cost: O(1), periodic O(log n), for each begin.
#pragma once

#include "bodies/slots.h"

namespace ballpit {

template <class V>
struct SortAndSweepCandidates {
  using Real = Scalar<V>;
  SlotsView<V> slots_view;
  Span<const int> begins_before_end;  ///< for each body
  int axis = 0;
  Real guard = 0;          ///< [m] by which intervals are longer than spheres
  Real period = 0;         ///< [m] length of a periodic axis, else 0
  bool is_narrow = false;  ///< periodic, and so short that spheres may meet on both sides: all pairs are candidates

  HOST_DEVICE const SlotsView<V>& slots() const { return slots_view; }
  HOST_DEVICE int threads() const { return slots_view.count; }
  HOST_DEVICE int slot_of(int thread) const { return thread; }

  template <class Visit>
  HOST_DEVICE void for_each_range(int slot, Visit&& visit) const {
    const int last = is_narrow ? slots_view.count : begins_before_end[slots_view.body[slot]];
    if (slot + 1 < last) visit(SlotRange{slot + 1, last});
    if (period > 0 && !is_narrow) visit_over_border(slot, visit);
  }

  template <class Visit>
  void for_each_range_of(int from, int to, Visit&& visit) const {
    for (int slot = from; slot < to; ++slot) {
      for_each_range(slot, [&](const SlotRange& range) { visit(slot, range); });
    }
  }

 private:
  HOST_DEVICE float begin_of(int slot) const {  // rounded as its key was
    return static_cast<float>(slots_view.coordinate[axis][slot] - (slots_view.radius[slot] + guard));
  }

  /// Visits the begins that an interval meets where it continues at the other end of the axis.
  template <class Visit>
  HOST_DEVICE void visit_over_border(int slot, Visit&& visit) const {
    const Real end = slots_view.coordinate[axis][slot] + (slots_view.radius[slot] + guard) - period + guard;
    int low = 0, high = slot;  // invariant: begins before `low` are at most `end`, those from `high` on are larger
    while (low < high) {
      const int middle = low + (high - low) / 2;
      if (begin_of(middle) <= end) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    if (low > 0) visit(SlotRange{0, low});
  }
};

}  // namespace ballpit
