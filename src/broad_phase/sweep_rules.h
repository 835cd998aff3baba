// SPDX-License-Identifier: MIT
// How sort and sweep keeps rounding from costing it a contact.
#pragma once

#include <limits>

#include "broad_phase/grid.h"
#include "broad_phase/parameters.h"

namespace ballpit {

template <class V>
struct SweepRules {
  Scalar<V> guard =
      0;  ///< by which intervals are longer than spheres: positions are rounded, keys even to single precision [m]
  bool is_narrow
      [kDimensions<V>]{};  ///< axes, periodic and so short that spheres may meet on both sides: all pairs are tested
};

template <class V>
SweepRules<V> sweep_rules(const BroadPhaseParameters<V>& parameters) {
  constexpr double kCoarser =
      double(std::numeric_limits<float>::epsilon()) / double(std::numeric_limits<Scalar<V>>::epsilon());
  const double largest = double(parameters.largest_radius());
  SweepRules<V> rules;
  rules.guard = static_cast<Scalar<V>>(kCoarser * rounding_guard(parameters.box) + 1e-6 * largest);
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    const double shortest = 4 * largest * (1 + 1e-5) + 8 * double(rules.guard);
    rules.is_narrow[axis] = parameters.box.is_periodic() && parameters.box.extent(axis) <= shortest;
  }
  return rules;
}

}  // namespace ballpit
