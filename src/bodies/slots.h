// SPDX-License-Identifier: MIT
// Slots: copies of the bodies in the order of a broad phase, one array per coordinate. The candidates of a body are
// then ranges of neighbours in memory, and a processor tests several at once.
//
//     slot      0    1    2    3    4          range-based broad phases yield ranges of slots for each slot:
//     body      4    0    3    1    2
//     x         .1   .3   .3   .7   .9             slot 1:  [2, 4)      each pair is in a range of one of its bodies
//     y         .5   .2   .4   .1   .8
//
#pragma once

#include "core/math.h"
#include "core/span.h"

namespace ballpit {

/// The number of unused values after the last slot: vector loads may read beyond it.
inline constexpr int kSlotPadding = 16;

/// The tag of a range that includes all of its slots. No slot has this tag.
inline constexpr unsigned kAnyTag = ~0u;

/// The slots first … last − 1; none if last ≤ first. If slots have tags, only those with this tag.
struct SlotRange {
  int first;
  int last;
  unsigned tag = 0;

  HOST_DEVICE int size() const { return first < last ? last - first : 0; }
};

template <class V>
struct SlotsView {
  using Real = Scalar<V>;
  int count = 0;                                  ///< slots in use; the spans have kSlotPadding more
  Span<const Real> coordinate[kDimensions<V>]{};  ///< [m]
  PerBody<Real> radius;                           ///< [m]
  Span<const int> body;                           ///< the body that a slot copies
  Span<const unsigned> tag;  ///< only with hashed grids: identifies the cells of a slot; else empty

  HOST_DEVICE V position(int slot) const {
    V p{};
    for (int axis = 0; axis < kDimensions<V>; ++axis) p[axis] = coordinate[axis][slot];
    return p;
  }

  /// Whether a slot between a range's ends has its tag.
  HOST_DEVICE bool matches_tag(int slot, const SlotRange& range) const {
    return tag.empty() || range.tag == kAnyTag || tag[slot] == range.tag;
  }
};

/// Whether a broad phase yields ranges of slots, not lists.
template <class Candidates>
concept GivesRanges = requires(const Candidates& candidates) {
  candidates.slots();
};

/// Kernel: copies body body[slot] into its slot.
template <class V>
struct GatherSlot {
  using Real = Scalar<V>;
  Span<const V> position;
  PerBody<Real> from_radius;
  Span<const int> body;
  Span<Real> coordinate[kDimensions<V>];
  Span<Real> radius;  ///< empty if all are equal

  HOST_DEVICE void operator()(int slot) const {
    const int i = body[slot];
    const V p = position[i];
    for (int axis = 0; axis < kDimensions<V>; ++axis) coordinate[axis][slot] = p[axis];
    if (!radius.empty()) radius[slot] = from_radius[i];
  }
};

/// The memory of the slots, reused by each search.
template <class V, class Exec>
class Slots {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// Makes room. Then fill body() and call gather().
  void resize(int64_t count) { body_.resize((count_ = count) + kSlotPadding); }

  Span<int> body() { return {body_.span().data(), count_}; }

  void gather(Exec& exec, Span<const V> position, PerBody<Real> radius) {
    GatherSlot<V> kernel{position, radius, body(), {}, {}};
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      coordinate_[axis].resize(count_ + kSlotPadding);
      kernel.coordinate[axis] = coordinate_[axis].span();
    }
    uniform_radius_ = radius;
    if (!radius.is_uniform()) {
      radius_.resize(count_ + kSlotPadding);
      kernel.radius = radius_.span();
    }
    exec.parallel_for("gather slots", count_, kernel);
  }

  SlotsView<V> view() const {
    SlotsView<V> view;
    view.count = static_cast<int>(count_);
    for (int axis = 0; axis < kDimensions<V>; ++axis) view.coordinate[axis] = coordinate_[axis].span();
    view.radius = uniform_radius_.is_uniform() ? uniform_radius_ : PerBody<Real>(radius_.span().data(), 1);
    view.body = body_.span();
    return view;
  }

  int64_t bytes() const {
    int64_t sum = body_.bytes() + radius_.bytes();
    for (const Buffer<Real>& buffer : coordinate_) sum += buffer.bytes();
    return sum;
  }

 private:
  int64_t count_ = 0;
  Buffer<int> body_;
  Buffer<Real> coordinate_[kDimensions<V>];
  Buffer<Real> radius_;
  PerBody<Real> uniform_radius_;
};

}  // namespace ballpit
