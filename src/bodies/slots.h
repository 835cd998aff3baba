// SPDX-License-Identifier: MIT
// Slots: copies of the bodies in the order of a broad phase, coordinate by coordinate, so that the candidates of a body
// are ranges of neighbours in memory and a processor tests many at once.
//
//     slot      0    1    2    3    4          range-based broad phases give, for each slot, ranges of slots:
//     body      4    0    3    1    2
//     x         .1   .3   .3   .7   .9             slot 1:  [2, 4)        each pair in the range of one of the two
//     y         .5   .2   .4   .1   .8
//
#pragma once

#include "core/host_device.h"
#include "core/math.h"
#include "core/span.h"

namespace ballpit {

/// Vector loads may run beyond the last slot; buffers of slots hold so many values more than slots.
inline constexpr int kSlotPadding = 16;

/// Of a range that is meant whole; no slot has it.
inline constexpr unsigned kAnyTag = ~0u;

/// Candidates in a row: slots first … last − 1, none where last ≤ first; where slots have tags, only those with this one.
struct SlotRange {
  int first;
  int last;
  unsigned tag = 0;

  HOST_DEVICE int size() const { return first < last ? last - first : 0; }
};

template <class V>
struct SlotsView {
  using Real = Scalar<V>;
  int count = 0;                                  ///< slots in use; the spans are longer by kSlotPadding
  Span<const Real> coordinate[kDimensions<V>]{};  ///< [m]
  PerBody<Real> radius;                           ///< [m]
  Span<const int> body;                           ///< whose copy a slot holds
  Span<const unsigned> tag;                       ///< of hashed grids: tells which cells a slot belongs to; or empty

  HOST_DEVICE V position(int slot) const {
    V p{};
    for (int axis = 0; axis < kDimensions<V>; ++axis) p[axis] = coordinate[axis][slot];
    return p;
  }

  /// Whether a slot that lies in a range is meant by it.
  HOST_DEVICE bool is_meant(int slot, const SlotRange& range) const {
    return tag.empty() || range.tag == kAnyTag || tag[slot] == range.tag;
  }
};

/// Whether a broad phase gives its candidates as ranges of slots.
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
  Span<Real> radius;  ///< empty where all are equal

  HOST_DEVICE void operator()(int slot) const {
    const int i = body[slot];
    const V p = position[i];
    for (int axis = 0; axis < kDimensions<V>; ++axis) coordinate[axis][slot] = p[axis];
    if (!radius.empty()) radius[slot] = from_radius[i];
  }
};

/// The memory of slots, kept from search to search.
template <class V, class Exec>
class Slots {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// Makes room; fill body() next, then gather().
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
