// SPDX-License-Identifier: MIT
// The inner loop of the CPU's range-based methods: spheres against ranges of slots, as many at once as the processor
// tests, chosen when the program runs (Highway: SSE2 to AVX-512, NEON, SVE). Same arithmetic, same order, same bits as
// in_contact(): no fused operations, so what is found does not depend on the processor.
//
//     group     slots 4 5 6 of one cell, and the ranges that all of them look at: 7–8, 20–22, 31–33
//     packed    4 5 6 7 8 20 21 22 31 32 33     copied side by side once, so that few vectors hold them all
//     tests     4 × (5 … 33)   5 × (6 … 33)   6 × (7 … 33)
//
// Ranges that fill vectors by themselves are read where they lie. Pairs of a candidate list are tested in the same way, their
// positions gathered from the bodies.
#pragma once

#include "simulate/narrowphase/pair_blocks.h"
#include "simulate/slots.h"
#include "simulate/state.h"

namespace ballpit {

/// Slots first … last − 1, each to be tested against those after it in the group, and against all of the ranges
/// first_range … last_range − 1.
struct SlotGroup {
  int first;
  int last;
  int first_range;
  int last_range;
};

/// Groups, and the ranges that they refer to.
struct RangeTasks {
  Span<const SlotGroup> groups;
  Span<const SlotRange> ranges;
};

/// Tests each group and appends the pairs in contact, lower body first. Tags are compared where the slots have them.
template <class V>
void test_ranges(const SlotsView<V>& slots, const Box<V>& box, const RangeTasks& tasks, PairBuffer& found);

/// Tests pairs of bodies by index and appends those in contact, in their order.
template <class V>
void test_pairs(Span<const V> position, const PerBody<Scalar<V>>& radius, const Box<V>& box, Span<const Pair> pairs,
                PairBuffer& found);

/// The instructions that these use on this processor: "AVX3".
const char* range_test_instructions();

}  // namespace ballpit
