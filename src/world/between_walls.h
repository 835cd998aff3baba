// SPDX-License-Identifier: MIT
// One coordinate of a sphere that meets only walls during a step. Exact for any number of bounces.
//
//     low ├──▸────────────┤ high     p(t) = p + v·t + a·t²/2;  at a wall v ← −e·v, with the v at that moment
//
// Walls are at right angles and there is no friction, so coordinates are independent. A sphere that leaves a wall at speed w
// against an acceleration a returns after 2w/a, and comes to rest after 2w/(a·(1 − e)).
// Cost: O(bounces). Source: docs/responses.md, "Swept contacts". Its sibling for pairs is swept.h.
#pragma once

#include <cmath>

#include "core/host_device.h"

namespace ballpit {

/// The time [s] until a plane `distance` [m] ahead is reached at `speed` [m/s] and `acceleration` [m/s²], which may be
/// negative. Longer than any step if it is not reached.
template <class Real>
HOST_DEVICE Real time_to_wall(Real distance, Real speed, Real acceleration) {
  constexpr Real kNever = Real(1e30);
  if (speed <= 0 && acceleration <= 0) return kNever;
  if (distance <= 0 && speed > 0) return 0;
  const Real squared = speed * speed + 2 * acceleration * distance;
  if (speed > 0) return squared < 0 ? kNever : 2 * distance / (speed + std::sqrt(squared));
  return (-speed + std::sqrt(squared > 0 ? squared : Real(0))) / acceleration;
}

/// The two walls along one axis.
template <class Real>
struct BetweenWalls {
  Real low, high;     ///< [m] positions of the centre in contact with them
  Real acceleration;  ///< [m/s²]
  Real restitution;

  static constexpr int kMaxBounces = 32;  ///< in a step; after that the rest of the step is lost

  /// Advances a sphere by `left` [s]; returns the speed that the wall at `low` gave it [m/s].
  HOST_DEVICE Real fly(Real& position, Real& velocity, Real left) const {
    Real given = 0;
    for (int k = 0; k < kMaxBounces; ++k) {
      const Real to_low = time_to_wall(position - low, -velocity, -acceleration);
      const Real to_high = time_to_wall(high - position, velocity, acceleration);
      const Real side = to_low <= to_high ? Real(-1) : Real(1);
      const Real time = side < 0 ? to_low : to_high;
      if (time >= left) {
        position = inside(position + velocity * left + acceleration * left * left / 2);
        velocity += acceleration * left;
        return given;
      }
      const Real wall = side < 0 ? low : high, pressing = side * acceleration;
      const Real squared = velocity * velocity + 2 * pressing * (side * (wall - position));
      const Real arriving = std::sqrt(squared > 0 ? squared : Real(0)), parting = restitution * arriving;
      left -= time;
      position = wall;
      velocity = -side * parting;
      if (side < 0) given += arriving + parting;
      if (!(pressing > 0)) continue;
      const Real period = 2 * parting / pressing;
      if (period <= left * (1 - restitution)) {  // comes to rest within the step
        if (side < 0) given += pressing * left - parting;
        velocity = 0;
        return given;
      }
      if (restitution == 1 && period < left) {  // identical bounces
        const Real bounces = std::floor(left / period);
        left -= bounces * period;
        if (side < 0) given += bounces * 2 * parting;
      }
    }
    return given;
  }

  HOST_DEVICE Real inside(Real position) const {
    if (position < low) return low;
    return position > high ? high : position;
  }
};

}  // namespace ballpit
