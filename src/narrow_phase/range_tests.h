// SPDX-License-Identifier: MIT
// The inner loop of the CPU's range-based methods: tests spheres against ranges of slots, a vector of slots at a time.
// The vector instructions are chosen when the program runs (Highway: SSE2 to AVX-512, NEON, SVE). The arithmetic is
// that of in_contact(), in the same order and without fused operations, so results are bit-identical on all processors.
//
//     task      slot 4 against slots 20 – 25           hits   (4, 20, 001001)           pairs   (4, 20) (4, 23)
//
// A short range takes one vector. Hits are stored as bits and evaluated later, many at a time: evaluating each vector
// at once would cost a branch that no processor can predict. Pairs of a candidate list are tested in the same way, with
// positions gathered from the bodies.
#pragma once

#include <type_traits>

#include "bodies/box.h"
#include "bodies/slots.h"
#include "narrow_phase/pair_blocks.h"

namespace ballpit {

/// Whether the tests below serve an executor.
template <class V, class Exec>
inline constexpr bool kHasVectorTests = std::is_same_v<Exec, CpuExecutor>&& std::is_same_v<Scalar<V>, float>;

/// A slot to be tested against the slots of a range, which is not empty.
struct RangeTask {
  int slot;
  SlotRange range;
};

/// The tests, by the best instructions of this processor.
template <class V>
struct VectorTests {
  /// Executes the tasks and appends the pairs in contact, lower body first. Compares tags if the slots have them.
  void (*test_ranges)(const SlotsView<V>& slots, const Box<V>& box, Span<const RangeTask> tasks, PairBuffer& found);

  /// Tests pairs of bodies and appends those in contact, in the same order.
  void (*test_pairs)(Span<const V> position, const PerBody<Scalar<V>>& radius, const Box<V>& box,
                     Span<const Pair> pairs, PairBuffer& found);
};

/// For Vec2 and Vec3.
template <class V>
VectorTests<V> vector_tests();

/// The instruction set that these functions use on this processor: "AVX3".
const char* range_test_instructions();

}  // namespace ballpit
