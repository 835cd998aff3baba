// SPDX-License-Identifier: MIT
// Compiled once for each set of instructions: Highway includes this file again and again, and picks at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simulate/narrowphase/range_tests.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "simulate/narrowphase/range_tests.h"

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

/// Where slots lie, held apart from what is written, so that the addresses stay in registers.
template <int kDims>
struct SlotPointers {
  const float* coordinate[kDims];
  const float* radius;
  const int32_t* body;
};

/// A sphere, once in each lane.
template <int kDims>
struct OwnSphere {
  hn::Vec<Floats> coordinate[kDims];
  hn::Vec<Floats> radius;
  hn::Vec<Ints> body;
};

/// Candidates of a group, side by side; in the nearest cache.
template <int kDims>
struct Packed {
  static constexpr int kCapacity = 512;
  float coordinate[kDims][kCapacity + kSlotPadding];
  float radius[kCapacity + kSlotPadding];
  int32_t body[kCapacity + kSlotPadding];
  int count = 0;

  SlotPointers<kDims> pointers() const {
    SlotPointers<kDims> result;
    for (int axis = 0; axis < kDims; ++axis) result.coordinate[axis] = coordinate[axis];
    result.radius = radius;
    result.body = body;
    return result;
  }
};

template <bool kPeriodic, bool kEqual, bool kTagged, int kDims>
class RangeTester {
 public:
  template <class V>
  RangeTester(const SlotsView<V>& slots, const Box<V>& box) : tag_(slots.tag.data()) {
    for (int axis = 0; axis < kDims; ++axis) {
      slots_.coordinate[axis] = slots.coordinate[axis].data();
      period_[axis] = box.max[axis] - box.min[axis];
    }
    slots_.radius = slots.radius.data();
    slots_.body = slots.body.data();
  }

  void Test(const RangeTasks& tasks, PairBuffer& found) {
    found_ = &found;
    out_ = reinterpret_cast<int32_t*>(found.end());
    for (const SlotGroup& group : tasks.groups) TestGroup(group, tasks.ranges.data());
    found.set_end(reinterpret_cast<const Pair*>(out_));
  }

 private:
  // Longer ranges fill vectors by themselves.
  static constexpr int kLongRange = 4 * kSlotPadding;
  static constexpr int kTile = 1024;

  void TestGroup(const SlotGroup& group, const SlotRange* ranges) {
    if (group.last - group.first == 1) {  // nobody to share what would be packed
      const OwnSphere<kDims> own = Own(group.first);
      for (int r = group.first_range; r < group.last_range; ++r) {
        Reserve(ranges[r].size());
        TestOfTag(own, ranges[r]);
      }
      return;
    }
    packed_.count = 0;
    const bool is_packed = group.last - group.first <= kLongRange;
    if (is_packed) {
      Pack<false>({group.first, group.last, 0});
    } else {
      for (int s = group.first; s < group.last; ++s) {
        Reserve(group.last - s);
        TestRange<false>(slots_, Own(s), {s + 1, group.last, 0});
      }
    }
    const int own = packed_.count;
    for (int r = group.first_range; r < group.last_range; ++r) {
      if (ranges[r].last - ranges[r].first > kLongRange) {
        TestTiles(group, ranges[r]);
      } else {
        if (packed_.count > Packed<kDims>::kCapacity - kLongRange) Flush(group, own);
        kTagged && !ranges[r].is_of_any_tag ? Pack<kTagged>(ranges[r]) : Pack<false>(ranges[r]);
      }
    }
    if (is_packed) {
      Reserve(int64_t(own) * packed_.count);
      for (int k = 0; k < own; ++k) {
        if (k + 1 < packed_.count) TestRange<false>(packed_.pointers(), Own(group.first + k), {k + 1, packed_.count, 0});
      }
    } else {
      Flush(group, 0);
    }
  }

  /// Tests the whole group against a long range, tile by tile, so that a tile is read from memory once.
  void TestTiles(const SlotGroup& group, const SlotRange& range) {
    for (int first = range.first; first < range.last; first += kTile) {
      const SlotRange tile{first, std::min(first + kTile, range.last), range.tag, range.is_of_any_tag};
      Reserve(int64_t(tile.size()) * (group.last - group.first));
      for (int s = group.first; s < group.last; ++s) TestOfTag(Own(s), tile);
    }
  }

  /// Tests the whole group against what is packed beyond its own slots, and makes room.
  void Flush(const SlotGroup& group, int own) {
    Reserve(int64_t(packed_.count - own) * (group.last - group.first));
    for (int s = group.first; s < group.last; ++s) TestRange<false>(packed_.pointers(), Own(s), {own, packed_.count, 0});
    packed_.count = own;
  }

  /// Makes room for `pairs` more, and for what a whole vector writes beyond them.
  HWY_INLINE void Reserve(int64_t pairs) {
    found_->set_end(reinterpret_cast<const Pair*>(out_));
    found_->reserve(pairs + 2 * kSlotPadding);
    out_ = reinterpret_cast<int32_t*>(found_->end());
  }

  /// Appends a range of at most kLongRange slots.
  template <bool kFiltered>
  HWY_INLINE void Pack(const SlotRange& range) {
    const Floats f;
    const Ints d;
    const Unsigneds u;
    const int lanes = static_cast<int>(hn::Lanes(f));
    const SlotPointers<kDims> slots = slots_;
    int at = packed_.count;  // held here: a store might change a member, as far as the compiler knows
    for (int j = range.first; j < range.last; j += lanes) {
      hn::Mask<Floats> wanted = hn::FirstN(f, static_cast<size_t>(range.last - j));
      if constexpr (kFiltered) {
        wanted = hn::And(wanted, hn::RebindMask(f, hn::Eq(hn::LoadU(u, tag_ + j), hn::Set(u, range.tag))));
      }
      const auto store = [&](const float* from, float* to) HWY_ATTR {
        const hn::Vec<Floats> values = hn::LoadU(f, from + j);
        hn::StoreU(kFiltered ? hn::Compress(values, wanted) : values, f, to + at);
      };
      for (int axis = 0; axis < kDims; ++axis) store(slots.coordinate[axis], packed_.coordinate[axis]);
      if constexpr (!kEqual) store(slots.radius, packed_.radius);
      const hn::Vec<Ints> body = hn::LoadU(d, slots.body + j);
      hn::StoreU(kFiltered ? hn::Compress(body, hn::RebindMask(d, wanted)) : body, d, packed_.body + at);
      at += kFiltered ? static_cast<int>(hn::CountTrue(f, wanted)) : std::min(lanes, range.last - j);
    }
    packed_.count = at;
  }

  HWY_INLINE OwnSphere<kDims> Own(int slot) const {
    const Floats f;
    OwnSphere<kDims> own;
    for (int axis = 0; axis < kDims; ++axis) own.coordinate[axis] = hn::Set(f, slots_.coordinate[axis][slot]);
    own.radius = hn::Set(f, slots_.radius[kEqual ? 0 : slot]);
    own.body = hn::Set(Ints(), slots_.body[slot]);
    return own;
  }

  /// Which of the spheres from j on touch `own`.
  HWY_INLINE hn::Mask<Floats> Touching(const SlotPointers<kDims>& from, const OwnSphere<kDims>& own, int j) const {
    const Floats f;
    hn::Vec<Floats> squared = hn::Zero(f);
    for (int axis = 0; axis < kDims; ++axis) {
      const hn::Vec<Floats> others = hn::LoadU(f, from.coordinate[axis] + j);
      const hn::Vec<Floats> d = Displacement<kPeriodic>(own.coordinate[axis], others, period_[axis]);
      squared = axis == 0 ? hn::Mul(d, d) : hn::Add(squared, hn::Mul(d, d));
    }
    const hn::Vec<Floats> radii = hn::Add(own.radius, kEqual ? own.radius : hn::LoadU(f, from.radius + j));
    return hn::Le(squared, hn::Mul(radii, radii));
  }

  HWY_INLINE void TestOfTag(const OwnSphere<kDims>& own, const SlotRange& range) {
    if (kTagged && !range.is_of_any_tag) {
      TestRange<kTagged>(slots_, own, range);
    } else {
      TestRange<false>(slots_, own, range);
    }
  }

  template <bool kFiltered>
  HWY_INLINE void TestRange(const SlotPointers<kDims>& from, const OwnSphere<kDims>& own, const SlotRange& range) {
    const Floats f;
    const Ints d;
    const Unsigneds u;
    const int lanes = static_cast<int>(hn::Lanes(f));
    int32_t* out = out_;
    for (int j = range.first; j < range.last; j += lanes) {
      hn::Mask<Floats> hits = hn::And(Touching(from, own, j), hn::FirstN(f, static_cast<size_t>(range.last - j)));
      if constexpr (kFiltered) {
        hits = hn::And(hits, hn::RebindMask(f, hn::Eq(hn::LoadU(u, tag_ + j), hn::Set(u, range.tag))));
      }
      const hn::Mask<Ints> mask = hn::RebindMask(d, hits);
      const hn::Vec<Ints> others = hn::Compress(hn::LoadU(d, from.body + j), mask);
      hn::StoreInterleaved2(hn::Min(own.body, others), hn::Max(own.body, others), d, out);
      out += 2 * hn::CountTrue(d, mask);
    }
    out_ = out;
  }

  SlotPointers<kDims> slots_;
  const unsigned* tag_;
  float period_[kDims];
  PairBuffer* found_ = nullptr;
  int32_t* out_ = nullptr;  // where the next pair goes
  Packed<kDims> packed_;
};

template <bool kPeriodic, class V>
void ChooseTests(const SlotsView<V>& slots, const Box<V>& box, const RangeTasks& tasks, PairBuffer& found) {
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
void TestRanges(const SlotsView<V>& slots, const Box<V>& box, const RangeTasks& tasks, PairBuffer& found) {
  box.is_periodic() ? ChooseTests<true>(slots, box, tasks, found) : ChooseTests<false>(slots, box, tasks, found);
}

/// One coordinate of the bodies whose indices stand in the lanes.
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
void TestPairs(Span<const V> position, const PerBody<float>& radius, const Box<V>& box, Span<const Pair> pairs,
               PairBuffer& found) {
  const auto test = [&](auto filter) { filter(position.data(), radius.data(), box, pairs, found); };
  if (radius.is_uniform()) {
    test(box.is_periodic() ? FilterPairs<true, true, V> : FilterPairs<false, true, V>);
  } else {
    test(box.is_periodic() ? FilterPairs<true, false, V> : FilterPairs<false, false, V>);
  }
}

void TestRanges2(const SlotsView<Vec2>& slots, const Box<Vec2>& box, const RangeTasks& tasks, PairBuffer& found) {
  TestRanges(slots, box, tasks, found);
}
void TestRanges3(const SlotsView<Vec3>& slots, const Box<Vec3>& box, const RangeTasks& tasks, PairBuffer& found) {
  TestRanges(slots, box, tasks, found);
}
void TestPairs2(Span<const Vec2> position, const PerBody<float>& radius, const Box<Vec2>& box, Span<const Pair> pairs,
                PairBuffer& found) {
  TestPairs(position, radius, box, pairs, found);
}
void TestPairs3(Span<const Vec3> position, const PerBody<float>& radius, const Box<Vec3>& box, Span<const Pair> pairs,
                PairBuffer& found) {
  TestPairs(position, radius, box, pairs, found);
}

const char* Instructions() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace ballpit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ballpit {

HWY_EXPORT(TestRanges2);
HWY_EXPORT(TestRanges3);
HWY_EXPORT(TestPairs2);
HWY_EXPORT(TestPairs3);
HWY_EXPORT(Instructions);

template <>
void test_ranges(const SlotsView<Vec2>& slots, const Box<Vec2>& box, const RangeTasks& tasks, PairBuffer& found) {
  HWY_DYNAMIC_DISPATCH(TestRanges2)(slots, box, tasks, found);
}
template <>
void test_ranges(const SlotsView<Vec3>& slots, const Box<Vec3>& box, const RangeTasks& tasks, PairBuffer& found) {
  HWY_DYNAMIC_DISPATCH(TestRanges3)(slots, box, tasks, found);
}
template <>
void test_pairs(Span<const Vec2> position, const PerBody<float>& radius, const Box<Vec2>& box, Span<const Pair> pairs,
                PairBuffer& found) {
  HWY_DYNAMIC_DISPATCH(TestPairs2)(position, radius, box, pairs, found);
}
template <>
void test_pairs(Span<const Vec3> position, const PerBody<float>& radius, const Box<Vec3>& box, Span<const Pair> pairs,
                PairBuffer& found) {
  HWY_DYNAMIC_DISPATCH(TestPairs3)(position, radius, box, pairs, found);
}

const char* range_test_instructions() { return HWY_DYNAMIC_DISPATCH(Instructions)(); }

}  // namespace ballpit
#endif
