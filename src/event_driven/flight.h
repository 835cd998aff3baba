// SPDX-License-Identifier: MIT
// Free flight on parabolas under gravity, and closed formulas for the times at which a sphere meets another one or a
// plane.
//
// Every time is computed as c / (b + √disc), where both terms have the same sign: never as a difference of nearly equal
// numbers. Times count from the present state. A sphere that rounding has left slightly beyond a surface meets it at
// once if it moves inwards, and not at all if it moves outwards. So no collision is lost, and none happens twice.
// Source of this rule: Bannerman, Strobl, Formella, Pöschel, "Stable algorithm for event detection in event-driven
// particle dynamics" (2014), doi 10.1007/s40571-014-0021-8.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/math.h"

namespace ballpit {

/// [s] The time of an event that does not happen.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A sphere since its latest event: all data that forecasts of other spheres read, in one cache line.
template <class V>
struct alignas(64) Flight {
  V position{};             ///< [m] at `time`
  V velocity{};             ///< [m/s] at `time`
  double time = 0;          ///< [s] since the epoch
  uint32_t collisions = 0;  ///< so far, with spheres and walls; a forecast made at an older number is void

  V position_at(double now, const V& gravity) const {
    const double elapsed = now - time;
    return position + elapsed * (velocity + (0.5 * elapsed) * gravity);
  }
  V velocity_at(double now, const V& gravity) const { return velocity + (now - time) * gravity; }

  void advance(double now, const V& gravity) {
    position = position_at(now, gravity);
    velocity = velocity_at(now, gravity);
    time = now;
  }
};

/// Paths that meet a sphere's surface at a smaller angle [rad] miss it: they would enter it by less than 5e-21 of the
/// radii, and rounding errors change the angle by more, especially just after a collision.
inline constexpr double kGrazing = 1e-10;

/// The time [s] until two spheres, `d` apart [m] and with relative velocity `u` [m/s], come within `radii` of each
/// other. |d + u·t| = radii, smaller root: u²t² + 2bt + c = 0. Gravity acts on both alike and drops out.
template <class V>
double time_to_contact(const V& d, const V& u, double radii) {
  const double b = dot(d, u), u_squared = dot(u, u), radii_squared = radii * radii;
  const double c = dot(d, d) - radii_squared;
  // Tests b < 0 (approaching) and b² > u²·c in one comparison: together they are usually false, each alone is
  // unpredictable.
  if (!(b * -std::fabs(b) > u_squared * std::max(c, kGrazing * kGrazing * radii_squared))) return kNever;
  return c <= 0 ? 0 : c / (-b + std::sqrt(b * b - u_squared * c));
}

/// The time [s] until a point meets a plane that is `distance` ahead [m], at the speed `approach` [m/s] that grows by
/// `acceleration` [m/s²]; both may be negative. The smallest t ≥ 0 with distance = approach·t + acceleration·t²/2 at
/// which the point moves towards the plane.
inline double time_to_plane(double distance, double approach, double acceleration) {
  if (approach <= 0 && acceleration <= 0) return kNever;
  if (distance <= 0 && approach > 0) return 0;
  const double discriminant = approach * approach + 2 * acceleration * distance;
  if (approach > 0) {
    return discriminant < 0 ? kNever : 2 * distance / (approach + std::sqrt(discriminant));
  }
  return (-approach + std::sqrt(std::max(0.0, discriminant))) / acceleration;
}

}  // namespace ballpit
