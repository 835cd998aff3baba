// SPDX-License-Identifier: MIT
// The axis along which positions vary most. Few intervals overlap on it, so it is the best one to sweep along.
// Cost: O(n), one reduction.
#pragma once

#include "core/span.h"
#include "exec/reduce.h"

namespace ballpit {

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
  V center;  ///< subtracted first, so that the squares do not cancel

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
int widest_axis(Exec& exec, Span<const V> position, const V& center) {
  if (position.empty()) return 0;
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

}  // namespace ballpit
