// SPDX-License-Identifier: MIT
// Sort and sweep: each sphere's interval on one axis, begins and ends of all in one sorted list (slides 2 to 4).
//
//         b0 ────────── e0                        list    b0  b2  e0  b1  e2  e1
//               b2 ───────────── e2               slot     0   1       2            (the begins, numbered)
//                          b1 ───────── e1        thread b0 walks to e0 and tests b2; b2 walks to e2 and tests b1;
//     ──────────────────────────────────▶ axis    thread e0 returns at once
//
// The begins between a sphere's begin and its end are numbered without gaps: the candidates are one range of slots. In
// a periodic domain an interval that reaches over the border also meets the first begins of the list.
//
// Cost: one stable sort of 2n endpoints, O(n log n) or, by radix, O(n); then as many tests as intervals overlap on the
// axis, which is O(n^(5/3)) for a cube of spheres: in a crowd, most of what overlaps on an axis is far apart on the others.
// The walks differ in length, and half of all threads return at once: neighbours wait for each other on a GPU.
// Memory: 24 bytes a body, and a copy of position and radius.
// Source: Baraff, "Dynamic simulation of non-penetrating rigid bodies" (1992); Witkin, Baraff, Kass, "Physically Based
// Modeling" (SIGGRAPH course, 1997). Siblings: brute_force.h, linked_cell.h, sorted_grid.h.
#pragma once

#include <cstring>
#include <limits>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/slots.h"
#include "broad_phase/grid.h"
#include "broad_phase/inspection.h"
#include "core/span.h"
#include "exec/reduce.h"

namespace ballpit {

/// A number whose unsigned order is the order of finite floats.
HOST_DEVICE inline uint32_t sortable(float value) {
  uint32_t bits;  // std::bit_cast is not for every device
  std::memcpy(&bits, &value, sizeof(bits));
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

/// Kernel: endpoints i (begin of body i) and n + i (its end), before sorting. Begins come first, so that in a stable sort
/// a begin stands before an end at the same place: spheres that touch exactly meet.
template <class V>
struct StoreEndpoints {
  int axis;
  Scalar<V> guard;  ///< what rounding may hide, that of keys to single precision included [m]
  Span<const V> position;
  PerBody<Scalar<V>> radius;
  Span<uint32_t> keys;
  Span<int> endpoints;

  HOST_DEVICE void operator()(int i) const {
    const int n = static_cast<int>(position.size());
    const Scalar<V> x = position[i][axis], reach = radius[i] + guard;
    keys[i] = sortable(static_cast<float>(x - reach));
    keys[n + i] = sortable(static_cast<float>(x + reach));
    endpoints[i] = i;
    endpoints[n + i] = n + i;
  }
};

/// Kernel: 1 where the list has a begin.
struct MarkBegin {
  int n;
  Span<const int> endpoints;
  Span<int> is_begin;
  HOST_DEVICE void operator()(int p) const { is_begin[p] = endpoints[p] < n; }
};

/// Kernel: numbers the begins, and notes for each end how many begins stand before it.
struct NumberBegins {
  int n;
  Span<const int> endpoints;
  Span<const int> begins_before;
  Span<int> body_of_slot;
  Span<int> begins_before_end;  ///< of each body

  HOST_DEVICE void operator()(int p) const {
    const int endpoint = endpoints[p];
    if (endpoint < n) {
      body_of_slot[begins_before[p]] = endpoint;
    } else {
      begins_before_end[endpoint - n] = begins_before[p];
    }
  }
};

/// Kernel: where entry p of the sorted list lies, as its key told.
template <class V>
struct PlaceEndpoint {
  int axis;
  Scalar<V> guard;  ///< [m]
  BodiesView<V> bodies;
  Span<const int> endpoints;
  Span<float> at;  ///< [m]

  HOST_DEVICE void operator()(int p) const {
    const int n = static_cast<int>(bodies.size()), endpoint = endpoints[p];
    const bool is_end = endpoint >= n;
    const int i = is_end ? endpoint - n : endpoint;
    const Scalar<V> x = bodies.position[i][axis], reach = bodies.radius[i] + guard;
    at[p] = static_cast<float>(is_end ? x + reach : x - reach);
  }
};

template <class V>
struct SortAndSweepCandidates {
  using Real = Scalar<V>;
  SlotsView<V> slots_view;
  Span<const int> endpoints;          ///< the sorted list
  Span<const int> begins_before;      ///< of each list entry
  Span<const int> begins_before_end;  ///< of each body
  int axis = 0;
  Real guard = 0;
  Real period = 0;         ///< [m] length of a periodic axis, else 0
  bool is_narrow = false;  ///< periodic and so short that spheres may meet both ways round: all pairs are candidates

  HOST_DEVICE const SlotsView<V>& slots() const { return slots_view; }
  HOST_DEVICE int threads() const { return static_cast<int>(endpoints.size()); }

  /// One thread per list entry: an end has nothing to do.
  HOST_DEVICE int slot_of(int thread) const {
    return endpoints[thread] < slots_view.count ? begins_before[thread] : -1;
  }

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

  /// The begins that an interval meets when it goes on at the other end of the axis.
  template <class Visit>
  HOST_DEVICE void visit_over_border(int slot, Visit&& visit) const {
    const Real end = slots_view.coordinate[axis][slot] + (slots_view.radius[slot] + guard) - period + guard;
    int low = 0, high = slot;  // invariant: begins below `low` lie up to `end`, those from `high` on beyond
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

/// Sums for the variance along each axis.
struct AxisSums {
  double sum[3] = {0, 0, 0}, squares[3] = {0, 0, 0};

  HOST_DEVICE AxisSums operator+(const AxisSums& other) const {
    AxisSums result;
    for (int axis = 0; axis < 3; ++axis) {
      result.sum[axis] = sum[axis] + other.sum[axis];
      result.squares[axis] = squares[axis] + other.squares[axis];
    }
    return result;
  }
};

template <class V>
struct AxisSumsOf {
  Span<const V> position;
  V center;  ///< about which squares are summed, so that they do not cancel
  HOST_DEVICE AxisSums operator()(int i) const {
    AxisSums result;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const double x = double(position[i][axis]) - double(center[axis]);
      result.sum[axis] = x;
      result.squares[axis] = x * x;
    }
    return result;
  }
};

template <class V, class Exec>
class SortAndSweep {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  explicit SortAndSweep(const BroadPhaseParameters<V>& parameters) { plan(parameters); }

  void plan(const BroadPhaseParameters<V>& parameters) {
    box_ = parameters.box;
    wanted_axis_ = parameters.axis;
    constexpr double kCoarser =
        double(std::numeric_limits<float>::epsilon()) / double(std::numeric_limits<Real>::epsilon());
    guard_ = static_cast<Real>(kCoarser * rounding_guard(parameters.box) + 1e-6 * double(parameters.largest_radius()));
    largest_diameter_ = 2 * double(parameters.largest_radius());
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    const int64_t n = bodies.size();
    const int count = static_cast<int>(n);
    axis_ = wanted_axis_ >= 0 ? wanted_axis_ : widest_axis(exec, bodies.position);
    keys_.resize(2 * n);
    endpoints_.resize(2 * n);
    begins_before_.resize(2 * n + 1);
    begins_before_end_.resize(n);
    slots_.resize(n);
    exec.parallel_for(
        "store endpoints", n,
        StoreEndpoints<V>{axis_, guard_, bodies.position, bodies.radius, keys_.span(), endpoints_.span()});
    exec.sort_pairs("sort endpoints", keys_.span(), endpoints_.span());
    const Span<int> is_begin(reinterpret_cast<int*>(keys_.span().data()), 2 * n);  // the keys have done their work
    exec.parallel_for("mark begins", 2 * n, MarkBegin{count, endpoints_.span(), is_begin});
    exec.exclusive_scan("scan begins", Span<const int>(is_begin), begins_before_.span());
    exec.parallel_for(
        "number begins", 2 * n,
        NumberBegins{count, endpoints_.span(), begins_before_.span(), slots_.body(), begins_before_end_.span()});
    slots_.gather(exec, bodies.position, bodies.radius);
  }

  SortAndSweepCandidates<V> candidates() const {
    const double length = double(box_.max[axis_]) - double(box_.min[axis_]);
    const bool is_narrow = box_.is_periodic() && length <= 2 * largest_diameter_ * (1 + 1e-5) + 8 * double(guard_);
    return {slots_.view(),
            endpoints_.span(),
            begins_before_.span(),
            begins_before_end_.span(),
            axis_,
            guard_,
            box_.is_periodic() ? Real(length) : Real(0),
            is_narrow};
  }

  std::vector<GridInspection> inspect(Exec&) const { return {}; }

  int axis() const { return axis_; }

  /// The sorted list of these bodies, for which it was prepared. Intervals are larger by the guard, as they were sorted.
  std::vector<Endpoint> endpoints(Exec& exec, const BodiesView<V>& bodies) const {
    Buffer<float> places;
    places.resize(endpoints_.size());
    exec.parallel_for("place endpoints", places.size(),
                      PlaceEndpoint<V>{axis_, guard_, bodies, endpoints_.span(), places.span()});
    const std::vector<int> endpoints = exec.download(endpoints_.span());
    const std::vector<float> at = exec.download(places.span());
    const auto n = static_cast<int>(bodies.size());
    std::vector<Endpoint> result;
    for (size_t p = 0; p < at.size(); ++p) {
      const bool is_end = endpoints[p] >= n;
      result.push_back({at[p], is_end ? endpoints[p] - n : endpoints[p], is_end});
    }
    return result;
  }

  /// List entries between each begin and its end, in the order of the list; 0 for the ends, which return at once.
  std::vector<int> walks(Exec& exec) const {
    const std::vector<int> endpoints = exec.download(endpoints_.span());
    const int n = static_cast<int>(endpoints.size() / 2);
    std::vector<int> begin(static_cast<size_t>(n)), walks(endpoints.size(), 0);
    for (int p = 0; p < 2 * n; ++p) {
      const int endpoint = endpoints[static_cast<size_t>(p)];
      if (endpoint < n) {
        begin[static_cast<size_t>(endpoint)] = p;
      } else {
        const int from = begin[static_cast<size_t>(endpoint - n)];
        walks[static_cast<size_t>(from)] = p - from;
      }
    }
    return walks;
  }

  int64_t bytes() const {
    return keys_.bytes() + endpoints_.bytes() + begins_before_.bytes() + begins_before_end_.bytes() + slots_.bytes();
  }

 private:
  static int widest_axis(Exec& exec, Span<const V> position, const V& center) {
    const AxisSums spread =
        reduce(exec, "measure spread", position.size(), AxisSums{}, AxisSumsOf<V>{position, center}, Sum{});
    const double n = static_cast<double>(position.size());
    int widest = 0;
    double largest = -1;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const double variance = spread.squares[axis] - spread.sum[axis] * spread.sum[axis] / n;
      if (variance > largest) {
        largest = variance;
        widest = axis;
      }
    }
    return widest;
  }
  int widest_axis(Exec& exec, Span<const V> position) const {
    return position.empty() ? 0 : widest_axis(exec, position, (box_.min + box_.max) / Real(2));
  }

  Box<V> box_;
  int wanted_axis_ = kLargestAxis;
  int axis_ = 0;
  Real guard_ = 0;
  double largest_diameter_ = 0;
  Buffer<uint32_t> keys_;
  Buffer<int> endpoints_, begins_before_, begins_before_end_;
  Slots<V, Exec> slots_;
};

}  // namespace ballpit
