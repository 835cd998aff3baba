// SPDX-License-Identifier: MIT
// Highway includes this file once for each instruction set, and selects one when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/range_tests.cpp"
#include "narrow_phase/range_tests.h"

#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ballpit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kSlotPadding>;
using Ints = hn::RebindToSigned<Floats>;
using Unsigneds = hn::RebindToUnsigned<Floats>;

/// One coordinate's part of Box::displacement(): b − a, in a periodic domain to the nearest image.
template <bool kPeriodic>
HWY_INLINE hn::Vec<Floats> Displacement(hn::Vec<Floats> a, hn::Vec<Floats> b, float period) {
  hn::Vec<Floats> d = hn::Sub(b, a);
  if constexpr (kPeriodic) {
    const hn::Vec<Floats> length = hn::Set(Floats(), period);
    d = hn::Sub(d, hn::Mul(length, hn::Round(hn::Div(d, length))));
  }
  return d;
}

/// Which slots from `first` on touch the body `own`: bit k stands for slot first + k.
struct Hits {
  int own;
  int first;
  unsigned bits;
};

template <bool kPeriodic, bool kEqual, bool kTagged, int kDims>
class RangeTester {
 public:
  template <class V>
  RangeTester(const SlotsView<V>& slots, const Box<V>& box)
      : radius_(slots.radius.data()), body_(slots.body.data()), tag_(slots.tag.data()) {
    for (int axis = 0; axis < kDims; ++axis) {
      coordinate_[axis] = slots.coordinate[axis].data();
      period_[axis] = box.max[axis] - box.min[axis];
    }
  }

  void Test(Span<const RangeTask> tasks, PairBuffer& found) const {
    const RangeTester self = *this;  // a local copy, which no pointer can alias, stays in registers
    Hits hits[kHits + 1];
    int count = 0;
    for (const RangeTask& task : tasks) self.TestTask(task, hits, count, found);
    self.Append(hits, count, found);
  }

 private:
  static constexpr int kHits = 1024;

  HWY_INLINE void TestTask(const RangeTask& task, Hits* hits, int& count, PairBuffer& found) const {
    const Floats f;
    const int lanes = static_cast<int>(hn::Lanes(f));
    const int slot = task.slot, last = task.range.last;
    hn::Vec<Floats> own[kDims];
    for (int axis = 0; axis < kDims; ++axis) own[axis] = hn::Set(f, coordinate_[axis][slot]);
    const hn::Vec<Floats> own_radius = hn::Set(f, radius_[kEqual ? 0 : slot]);
    const int body = body_[slot];
    int j = task.range.first;
    do {  // a short range takes one vector
      hn::Mask<Floats> touching = hn::And(Touching(own, own_radius, j), hn::FirstN(f, static_cast<size_t>(last - j)));
      if constexpr (kTagged) touching = hn::And(touching, MatchesTag(task.range, j));
      const unsigned bits = Bits(touching);
      hits[count] = {body, j, bits};  // without a hit, the next one overwrites it: saves an unpredictable branch
      count += bits != 0;
      if (count == kHits) Append(hits, count, found);
      j += lanes;
    } while (j < last);
  }

  /// Which spheres from slot j on touch the one at `own`.
  HWY_INLINE hn::Mask<Floats> Touching(const hn::Vec<Floats>* own, hn::Vec<Floats> own_radius, int j) const {
    const Floats f;
    hn::Vec<Floats> squared = hn::Zero(f);
    for (int axis = 0; axis < kDims; ++axis) {
      const hn::Vec<Floats> others = hn::LoadU(f, coordinate_[axis] + j);
      const hn::Vec<Floats> d = Displacement<kPeriodic>(own[axis], others, period_[axis]);
      squared = axis == 0 ? hn::Mul(d, d) : hn::Add(squared, hn::Mul(d, d));
    }
    const hn::Vec<Floats> radii = hn::Add(own_radius, kEqual ? own_radius : hn::LoadU(f, radius_ + j));
    return hn::Le(squared, hn::Mul(radii, radii));
  }

  HWY_INLINE hn::Mask<Floats> MatchesTag(const SlotRange& range, int j) const {
    const Floats f;
    const Unsigneds u;
    const hn::Vec<Unsigneds> any = hn::Set(u, range.tag == kAnyTag ? ~0u : 0u);
    const hn::Vec<Unsigneds> other = hn::Xor(hn::LoadU(u, tag_ + j), hn::Set(u, range.tag));
    return hn::RebindMask(f, hn::Eq(hn::AndNot(any, other), hn::Zero(u)));
  }

  static HWY_INLINE unsigned Bits(hn::Mask<Floats> mask) {
    uint8_t bytes[8] = {};
    hn::StoreMaskBits(Floats(), mask, bytes);
    return bytes[0] | unsigned(bytes[1]) << 8;
  }

  /// Appends the pairs of all hits, and clears the hits.
  HWY_NOINLINE void Append(const Hits* hits, int& count, PairBuffer& found) const {
    found.reserve(int64_t(count) * kSlotPadding);
    Pair* out = found.end();
    for (int k = 0; k < count; ++k) {
      const int* const body = body_ + hits[k].first;
      for (unsigned bits = hits[k].bits; bits != 0; bits &= bits - 1) {
        const int own = hits[k].own, other = body[hwy::Num0BitsBelowLS1Bit_Nonzero32(bits)];
        *out++ = {own < other ? own : other, own < other ? other : own};
      }
    }
    found.set_end(out);
    count = 0;
  }

  const float* coordinate_[kDims];
  const float* radius_;
  const int32_t* body_;
  const unsigned* tag_;
  float period_[kDims];
};

template <bool kPeriodic, class V>
void ChooseTests(const SlotsView<V>& slots, const Box<V>& box, Span<const RangeTask> tasks, PairBuffer& found) {
  constexpr int kDims = kDimensions<V>;
  if (slots.radius.is_uniform()) {
    slots.tag.empty() ? RangeTester<kPeriodic, true, false, kDims>(slots, box).Test(tasks, found)
                      : RangeTester<kPeriodic, true, true, kDims>(slots, box).Test(tasks, found);
  } else {
    slots.tag.empty() ? RangeTester<kPeriodic, false, false, kDims>(slots, box).Test(tasks, found)
                      : RangeTester<kPeriodic, false, true, kDims>(slots, box).Test(tasks, found);
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
    hn::StoreInterleaved2(hn::Compress(i, mask), hn::Compress(j, mask), d, out);
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
