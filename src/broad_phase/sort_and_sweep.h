// SPDX-License-Identifier: MIT
// Sort and sweep: each sphere has an interval on one axis, and the begins and ends of all are in one sorted list
// (slides 2 to 4).
//
//         b0 ────────── e0                        list    b0  b2  e0  b1  e2  e1
//               b2 ───────────── e2               slot     0   1       2            (the begins, numbered)
//                          b1 ───────── e1        thread b0 tests the begins up to e0: b2; thread b2 those up to e2: b1
//     ──────────────────────────────────▶ axis
//
// The begins between a sphere's begin and its end have consecutive numbers, so the candidates are one range of slots
// (sweep_candidates.h), and no thread walks the list as on slide 4; lecture/kernels/sort_and_sweep.h does.
//
// Cost: one stable sort of 2n endpoints, O(n log n) or, by radix, O(n); then one test for each overlap on the axis,
// which is O(n^(5/3)) for a cube of spheres. Memory: 24 bytes a body, and a copy of position and radius. Source:
// Baraff, "Dynamic simulation of non-penetrating rigid bodies" (1992); Witkin, Baraff, Kass, "Physically Based
// Modeling" (SIGGRAPH course, 1997). Siblings: brute_force.h, linked_cell.h, sorted_grid.h.
#pragma once

#include <cstring>
#include <limits>

#include "bodies/bodies_view.h"
#include "broad_phase/grid.h"
#include "broad_phase/sweep_candidates.h"
#include "broad_phase/sweep_rules.h"
#include "exec/reduce.h"

namespace ballpit {

/// Maps floats to unsigned numbers in the same order.
HOST_DEVICE inline uint32_t sortable(float value) {
  uint32_t bits;  // std::bit_cast is not available on every device
  std::memcpy(&bits, &value, sizeof(bits));
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

/// Kernel: endpoints i (begin of body i) and n + i (its end), before sorting. Begins come first, so after a stable sort
/// a begin precedes an end with the same key: spheres that touch exactly are found.
template <class V>
struct StoreEndpoints {
  int axis;
  Scalar<V> guard;  ///< bound on the rounding error, including that of the keys to single precision [m]
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

/// Kernel: 1 for each begin in the list.
struct MarkBegin {
  int n;
  Span<const int> endpoints;
  Span<int> is_begin;
  HOST_DEVICE void operator()(int p) const { is_begin[p] = endpoints[p] < n; }
};

/// Kernel: numbers the begins, and stores for each end how many begins precede it.
struct NumberBegins {
  int n;
  Span<const int> endpoints;
  Span<const int> begins_before;
  Span<int> body_of_slot;
  Span<int> begins_before_end;  ///< for each body

  HOST_DEVICE void operator()(int p) const {
    const int endpoint = endpoints[p];
    if (endpoint < n) {
      body_of_slot[begins_before[p]] = endpoint;
    } else {
      begins_before_end[endpoint - n] = begins_before[p];
    }
  }
};

/// Sums for the variance along each axis.
struct AxisSums {
  Vec3d sum{0.0}, squares{0.0};

  HOST_DEVICE AxisSums operator+(const AxisSums& other) const { return {sum + other.sum, squares + other.squares}; }
};

template <class V>
struct AxisSumsOf {
  Span<const V> position;
  V center;  ///< subtracted first, so that the squares do not cancel

  HOST_DEVICE AxisSums operator()(int i) const {
    Vec3d x{0.0};
    for (int axis = 0; axis < kDimensions<V>; ++axis) x[axis] = double(position[i][axis]) - double(center[axis]);
    return {x, x * x};
  }
};

/// The axis along which positions vary most. Few intervals overlap on it, so it is the best one to sweep along.
template <class V, class Exec>
int widest_axis(Exec& exec, Span<const V> position, const V& center) {
  if (position.empty()) return 0;
  const AxisSums spread =
      reduce(exec, "measure spread", position.size(), AxisSums{}, AxisSumsOf<V>{position, center}, Sum{});
  const Vec3d variance = spread.squares - spread.sum * spread.sum / static_cast<double>(position.size());
  int widest = 0;
  double largest = -1;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    if (variance[axis] > largest) {
      largest = variance[axis];
      widest = axis;
    }
  }
  return widest;
}

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
    rules_ = sweep_rules(parameters);
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    const int64_t n = bodies.size();
    const int count = static_cast<int>(n);
    axis_ = wanted_axis_ >= 0 ? wanted_axis_ : widest_axis(exec, bodies.position, (box_.min + box_.max) / Real(2));
    keys_.resize(2 * n);
    endpoints_.resize(2 * n);
    begins_before_.resize(2 * n + 1);
    begins_before_end_.resize(n);
    slots_.resize(n);
    exec.parallel_for(
        "store endpoints", n,
        StoreEndpoints<V>{axis_, rules_.guard, bodies.position, bodies.radius, keys_.span(), endpoints_.span()});
    exec.sort_pairs("sort endpoints", keys_.span(), endpoints_.span());
    const Span<int> is_begin(reinterpret_cast<int*>(keys_.span().data()), 2 * n);  // reuses the keys' memory
    exec.parallel_for("mark begins", 2 * n, MarkBegin{count, endpoints_.span(), is_begin});
    exec.exclusive_scan("scan begins", Span<const int>(is_begin), begins_before_.span());
    exec.parallel_for(
        "number begins", 2 * n,
        NumberBegins{count, endpoints_.span(), begins_before_.span(), slots_.body(), begins_before_end_.span()});
    slots_.gather(exec, bodies.position, bodies.radius);
  }

  SortAndSweepCandidates<V> candidates() const {
    return {slots_.view(),
            begins_before_end_.span(),
            axis_,
            rules_.guard,
            box_.is_periodic() ? Real(box_.extent(axis_)) : Real(0),
            rules_.is_narrow[axis_]};
  }

  std::vector<GridInspection> inspect(Exec&) const { return {}; }

  int axis() const { return axis_; }

  /// The sorted list, for the bodies that it was prepared for. Intervals are as long as when sorted: longer by the
  /// guard.
  std::vector<Endpoint> endpoints(Exec& exec, const BodiesView<V>& bodies) const {
    const int64_t n = bodies.size();
    const std::vector<V> position = exec.download(bodies.position);
    const bool is_uniform = bodies.radius.is_uniform() && n > 0;
    const auto radius = exec.download(Span<const Real>(bodies.radius.data(), is_uniform ? 1 : n));
    std::vector<Endpoint> result;
    for (const int endpoint : exec.download(endpoints_.span())) {
      const bool is_end = endpoint >= n;
      const int body = is_end ? endpoint - static_cast<int>(n) : endpoint;
      const Real x = position[size_t(body)][axis_], reach = radius[is_uniform ? 0 : size_t(body)] + rules_.guard;
      result.push_back({static_cast<float>(is_end ? x + reach : x - reach), body, is_end});
    }
    return result;
  }

  int64_t bytes() const {
    return keys_.bytes() + endpoints_.bytes() + begins_before_.bytes() + begins_before_end_.bytes() + slots_.bytes();
  }

 private:
  Box<V> box_;
  int wanted_axis_ = kAutoAxis;
  int axis_ = 0;
  SweepRules<V> rules_;
  Buffer<uint32_t> keys_;
  Buffer<int> endpoints_, begins_before_, begins_before_end_;
  Slots<V, Exec> slots_;
};

}  // namespace ballpit
