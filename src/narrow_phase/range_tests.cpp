// SPDX-License-Identifier: MIT
// Highway includes this file once for each instruction set, and selects one when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/range_tests.cpp"
#include "narrow_phase/range_tests.h"

#include <hwy/foreach_target.h>  // IWYU pragma: keep

#include "narrow_phase/range_tester-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ballpit {
namespace HWY_NAMESPACE {

template <bool kPeriodic, bool kEqual, bool kTagged, class V>
void RunTasks(const SlotsView<V>& slots, const Box<V>& box, Span<const RangeTask> tasks, PairBuffer& found) {
  // A local object, which no pointer can alias, stays in registers.
  const RangeTester<kPeriodic, kEqual, kTagged, kDimensions<V>> tester(slots, box.max - box.min);
  Hits hits[HitQueue::kCapacity + 1];
  HitQueue queue{hits};
  for (const RangeTask& task : tasks) tester.Test(task.slot, task.range, queue, found);
  tester.Flush(queue, found);
}

template <bool kPeriodic, class V>
void ChooseTests(const SlotsView<V>& slots, const Box<V>& box, Span<const RangeTask> tasks, PairBuffer& found) {
  if (slots.radius.is_uniform()) {
    slots.tag.empty() ? RunTasks<kPeriodic, true, false>(slots, box, tasks, found)
                      : RunTasks<kPeriodic, true, true>(slots, box, tasks, found);
  } else {
    slots.tag.empty() ? RunTasks<kPeriodic, false, false>(slots, box, tasks, found)
                      : RunTasks<kPeriodic, false, true>(slots, box, tasks, found);
  }
}

template <class V>
void TestRanges(const SlotsView<V>& slots, const Box<V>& box, Span<const RangeTask> tasks, PairBuffer& found) {
  box.is_periodic() ? ChooseTests<true>(slots, box, tasks, found) : ChooseTests<false>(slots, box, tasks, found);
}

/// One coordinate of the bodies whose indices are in the lanes.
template <class V>
HWY_INLINE hn::Vec<Floats> Gather(const V* position, hn::Vec<Ints> body, int axis) {
  constexpr int kDims = kDimensions<V>;
  const hn::Vec<Ints> twice = hn::Add(body, body);
  return hn::GatherIndex(Floats(), &position[0][0] + axis, kDims == 2 ? twice : hn::Add(twice, body));
}

template <bool kPeriodic, bool kEqual, class V>
void FilterPairs(const V* position, const float* radius, const Box<V>& box, Span<const Pair> pairs, PairBuffer& found) {
  const Floats f;
  const Ints d;
  const int64_t lanes = static_cast<int64_t>(hn::Lanes(f));
  found.reserve(pairs.size() + 2 * kSlotPadding);
  int32_t* out = reinterpret_cast<int32_t*>(found.end());
  const auto* in = reinterpret_cast<const int32_t*>(pairs.data());
  const V period = box.max - box.min;
  int64_t k = 0;
  for (; k + lanes <= pairs.size(); k += lanes) {
    hn::Vec<Ints> i, j;
    hn::LoadInterleaved2(d, in + 2 * k, i, j);
    hn::Vec<Floats> squared = hn::Zero(f);
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const hn::Vec<Floats> apart =
          Displacement<kPeriodic>(Gather(position, i, axis), Gather(position, j, axis), period[axis]);
      squared = axis == 0 ? hn::Mul(apart, apart) : hn::Add(squared, hn::Mul(apart, apart));
    }
    const hn::Vec<Floats> radii = kEqual ? hn::Set(f, radius[0] + radius[0])
                                         : hn::Add(hn::GatherIndex(f, radius, i), hn::GatherIndex(f, radius, j));
    const hn::Mask<Ints> mask = hn::RebindMask(d, hn::Le(squared, hn::Mul(radii, radii)));
    hn::StoreInterleaved2(Compress(i, mask), Compress(j, mask), d, out);
    out += 2 * hn::CountTrue(d, mask);
  }
  auto* end = reinterpret_cast<Pair*>(out);
  for (; k < pairs.size(); ++k) {
    const Pair pair = pairs[k];
    const float radii = radius[kEqual ? 0 : pair.i] + radius[kEqual ? 0 : pair.j];
    *end = pair;
    end += in_contact(box.displacement(position[pair.i], position[pair.j]), radii);
  }
  found.set_end(end);
}

template <class V>
void TestPairs(Span<const V> position, const PerBody<Scalar<V>>& radius, const Box<V>& box, Span<const Pair> pairs,
               PairBuffer& found) {
  const auto test = [&](auto filter) { filter(position.data(), radius.data(), box, pairs, found); };
  if (radius.is_uniform()) {
    test(box.is_periodic() ? FilterPairs<true, true, V> : FilterPairs<false, true, V>);
  } else {
    test(box.is_periodic() ? FilterPairs<true, false, V> : FilterPairs<false, false, V>);
  }
}

VectorTests<Vec2> Tests2() { return {TestRanges<Vec2>, TestPairs<Vec2>}; }
VectorTests<Vec3> Tests3() { return {TestRanges<Vec3>, TestPairs<Vec3>}; }

const char* Instructions() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace ballpit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ballpit {

HWY_EXPORT(Tests2);
HWY_EXPORT(Tests3);
HWY_EXPORT(Instructions);

template <>
VectorTests<Vec2> vector_tests() {
  return HWY_DYNAMIC_DISPATCH(Tests2)();
}
template <>
VectorTests<Vec3> vector_tests() {
  return HWY_DYNAMIC_DISPATCH(Tests3)();
}

const char* range_test_instructions() { return HWY_DYNAMIC_DISPATCH(Instructions)(); }

}  // namespace ballpit
#endif
