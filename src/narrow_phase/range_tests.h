// SPDX-License-Identifier: MIT
// The inner loop of the CPU's range-based methods: spheres against ranges of slots, as many at once as the processor
// tests, chosen when the program runs (Highway: SSE2 to AVX-512, NEON, SVE). Same arithmetic, same order, same bits as
// in_contact(): no fused operations, so what is found does not depend on the processor.
//
//     task      slot 4 against slots 20 – 25           hits   (4, 20, 001001)           pairs   (4, 20) (4, 23)
//
// Short ranges take one vector each. What touches is noted as bits, and read when there are many: to look at each vector's
// outcome at once costs a branch that no processor can predict. Pairs of a candidate list are tested in the same way, their
// positions gathered from the bodies.
#pragma once

#include "bodies/box.h"
#include "bodies/pair.h"
#include "bodies/slots.h"
#include "core/span.h"
#include "narrow_phase/pair_blocks.h"

namespace ballpit {

/// A slot, to be tested against those of a range that is not empty.
struct RangeTask {
  int slot;
  SlotRange range;
};

/// Carries the tasks out and appends the pairs in contact, lower body first. Tags are compared where the slots have them.
template <class V>
void test_ranges(const SlotsView<V>& slots, const Box<V>& box, Span<const RangeTask> tasks, PairBuffer& found);

/// Tests pairs of bodies by index and appends those in contact, in their order.
template <class V>
void test_pairs(Span<const V> position, const PerBody<Scalar<V>>& radius, const Box<V>& box, Span<const Pair> pairs,
                PairBuffer& found);

/// The instructions that these use on this processor: "AVX3".
const char* range_test_instructions();

}  // namespace ballpit
