// SPDX-License-Identifier: MIT
// The vector loop shared by range_tests.cpp and cell_tests.cpp: tests a slot against a range of slots. Each of them
// includes this file once for each instruction set, so it has Highway's guard instead of #pragma once.
#if defined(BALLPIT_RANGE_TESTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BALLPIT_RANGE_TESTER_INL_H
#undef BALLPIT_RANGE_TESTER_INL_H
#else
#define BALLPIT_RANGE_TESTER_INL_H
#endif

#include <array>

#include <hwy/highway.h>

#include "narrow_phase/range_tests.h"

HWY_BEFORE_NAMESPACE();
namespace ballpit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kSlotPadding>;
using Ints = hn::RebindToSigned<Floats>;
using Unsigneds = hn::RebindToUnsigned<Floats>;

/// The mask of a vector's lanes as bits, the first lane in the lowest.
template <class D>
HWY_INLINE unsigned Bits(D d, hn::Mask<D> mask) {
  uint64_t bits = 0;
  hn::StoreMaskBits(d, mask, reinterpret_cast<uint8_t*>(&bits));
  return static_cast<unsigned>(bits);
}

/// Moves the lanes of the mask to the front; the others are undefined.
#if HWY_TARGET == HWY_AVX2
// GCC 12 copies the table of Highway 1.0.3 to the stack at each call. This one has a byte for each lane.
constexpr auto kFrontLanes = [] {
  std::array<uint64_t, 256> table{};
  for (unsigned bits = 0; bits < 256; ++bits) {
    for (unsigned lane = 0, front = 0; lane < 8; ++lane) {
      if ((bits >> lane & 1) != 0) table[bits] |= uint64_t(lane) << 8 * front++;
    }
  }
  return table;
}();

HWY_INLINE hn::Vec<Ints> Compress(hn::Vec<Ints> v, hn::Mask<Ints> mask) {
  const Ints d;
  const auto* const lanes = reinterpret_cast<const uint8_t*>(&kFrontLanes[Bits(d, mask)]);
  const auto index = hn::PromoteTo(d, hn::Load(hn::Rebind<uint8_t, Ints>(), lanes));
  return hn::TableLookupLanes(v, hn::IndicesFromVec(d, index));
}
#else
HWY_INLINE hn::Vec<Ints> Compress(hn::Vec<Ints> v, hn::Mask<Ints> mask) { return hn::Compress(v, mask); }
#endif

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

/// Hits whose pairs have not been appended yet. The count is not in memory that a call could change, so it stays in a
/// register.
struct HitQueue {
  static constexpr int kCapacity = 1024;
  Hits* hits;  ///< kCapacity + 1
  int count = 0;
};

template <bool kPeriodic, bool kEqual, bool kTagged, int kDims>
class RangeTester {
 public:
  template <class V>
  RangeTester(const SlotsView<V>& slots, const V& period)
      : radius_(slots.radius.data()), body_(slots.body.data()), tag_(slots.tag.data()) {
    for (int axis = 0; axis < kDims; ++axis) {
      coordinate_[axis] = slots.coordinate[axis].data();
      period_[axis] = period[axis];
    }
  }

  /// Tests a slot against those of a range.
  HWY_INLINE void Test(int slot, const SlotRange& range, HitQueue& queue, PairBuffer& found) const {
    const Floats f;
    const Ints d;
    const int lanes = static_cast<int>(hn::Lanes(f));
    hn::Vec<Floats> own[kDims];
    for (int axis = 0; axis < kDims; ++axis) own[axis] = hn::Set(f, coordinate_[axis][slot]);
    const hn::Vec<Floats> own_radius = hn::Set(f, radius_[kEqual ? 0 : slot]);
    const int body = body_[slot];
    int j = range.first;
    do {  // a short range takes one vector
      const hn::Mask<Floats> inside = hn::RebindMask(f, hn::Lt(hn::Iota(d, 0), hn::Set(d, range.last - j)));
      hn::Mask<Floats> touching = hn::And(Touching(own, own_radius, j), inside);
      if constexpr (kTagged) touching = hn::And(touching, MatchesTag(range, j));
      const unsigned bits = Bits(f, touching);
      // Without a hit, the next one overwrites it: saves an unpredictable branch.
      queue.hits[queue.count] = {body, j, bits};
      queue.count += bits != 0;
      if (queue.count == HitQueue::kCapacity) Flush(queue, found);
      j += lanes;
    } while (j < range.last);
  }

  /// Appends the pairs of all hits, and clears the hits.
  HWY_INLINE void Flush(HitQueue& queue, PairBuffer& found) const {
    Append(queue.hits, queue.count, found);
    queue.count = 0;
  }

 private:
  HWY_NOINLINE void Append(const Hits* hits, int count, PairBuffer& found) const {
    const Ints d;
    const hn::Half<Ints> half;
    const int lanes = static_cast<int>(hn::Lanes(half));
    found.reserve((int64_t(count) + 1) * kSlotPadding);  // vectors are written as a whole
    auto* out = reinterpret_cast<int32_t*>(found.end());
    const int* const bodies = body_;
    for (int k = 0; k < count; ++k) {
      const uint64_t bits = hits[k].bits;
      const hn::Mask<Ints> mask = hn::LoadMaskBits(d, reinterpret_cast<const uint8_t*>(&bits));
      const hn::Vec<Ints> own = hn::Set(d, hits[k].own), others = hn::LoadU(d, bodies + hits[k].first);
      const hn::Vec<Ints> lower = Compress(hn::Min(own, others), mask);
      const hn::Vec<Ints> higher = Compress(hn::Max(own, others), mask);
      const auto pairs = static_cast<int>(hwy::PopCount(bits));
      if (pairs <= lanes) {  // nearly always
        hn::StoreInterleaved2(hn::LowerHalf(half, lower), hn::LowerHalf(half, higher), half, out);
      } else {
        hn::StoreInterleaved2(lower, higher, d, out);
      }
      out += 2 * pairs;
    }
    found.set_end(reinterpret_cast<Pair*>(out));
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

  const float* coordinate_[kDims];
  const float* radius_;
  const int32_t* body_;
  const unsigned* tag_;
  float period_[kDims];
};

}  // namespace HWY_NAMESPACE
}  // namespace ballpit
HWY_AFTER_NAMESPACE();

#endif
