// SPDX-License-Identifier: MIT
// The force between two spheres in the penalty response, by the laws of penalty.h, and the damping ratio
// ζ = c / (2·√(k·m*)) of a dashpot that gives a collision the wanted restitution.
//
// The motion of a contact in units of its spring: ẍ + 2ζẋ + x = 0, x(0) = 0, ẋ(0) = 1, so x = exp(−ζt)·sin(ωt)/ω with
// ω = √(1−ζ²). The overlap ends at ωt = π. The force, −ẍ, ends at ωt = π − 2·asin ζ = 2·acos ζ, where ẋ = −exp(−ζt)
// (Schwager and Pöschel 2007, doi 10.1007/s10035-007-0065-z). With y = δ^(5/4) and dτ = δ^¼ dt, a Hertz contact is the
// same oscillator (Antypov and Elliott 2011, doi 10.1209/0295-5075/94/50004).
#pragma once

#include <algorithm>
#include <cmath>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/pair.h"

namespace ballpit {

inline constexpr double kMinRestitution = 0.01;

/// Restitution for ζ ≥ 0 if a contact ends when the overlap does: exp(−πζ/√(1−ζ²)), 0 from ζ = 1 on.
inline double restitution_to_overlap_end(double zeta) {
  return zeta < 1 ? std::exp(-M_PI * zeta / std::sqrt(1 - zeta * zeta)) : 0.0;
}

/// The same if it ends when the force would begin to pull: exp(−2ζ·acos ζ/√(1−ζ²)), with acosh ζ/√(ζ²−1) from ζ = 1 on.
inline double restitution_to_force_end(double zeta) {
  if (zeta == 1) return std::exp(-2.0);
  const double angle =
      zeta < 1 ? std::acos(zeta) / std::sqrt(1 - zeta * zeta) : std::acosh(zeta) / std::sqrt(zeta * zeta - 1);
  return std::exp(-2 * zeta * angle);
}

/// ζ for a restitution from 0 to 1. A spring with a dashpot cannot reach restitution 0, so values below kMinRestitution
/// count as kMinRestitution.
inline double damping_of(double restitution, bool ends_with_force) {
  if (restitution >= 1) return 0;
  const double e = std::max(restitution, kMinRestitution);
  const double log_e = std::log(e);
  if (!ends_with_force) return -log_e / std::sqrt(M_PI * M_PI + log_e * log_e);
  double low = 0, high = 100;  // restitution decreases with ζ
  for (int k = 0; k < 100; ++k) {
    const double middle = (low + high) / 2;
    (restitution_to_force_end(middle) > e ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// The law of a contact's force.
template <class Real>
struct PenaltyLaw {
  Real stiffness;     ///< k [N/m], or K [N/m^1.5]
  Real damping;       ///< ζ between spheres
  Real wall_damping;  ///< ζ at walls
  Real shear;         ///< [kg/s]
  bool is_hertz;
  bool ends_with_force;

  /// The factor of the dashpot's force, for a reduced mass.
  HOST_DEVICE Real dashpot(Real zeta, Real mass) const { return zeta * std::sqrt(stiffness * mass); }

  /// [N] pushing apart.
  HOST_DEVICE Real force(Real dashpot, Real overlap, Real separation) const {
    Real spring = stiffness * overlap, damped = 0;
    if (is_hertz) spring *= std::sqrt(overlap);
    if (dashpot > 0) {
      damped = dashpot * separation;
      damped *= is_hertz ? kRootOf5 * std::sqrt(std::sqrt(overlap)) : Real(2);
    }
    const Real force = spring - damped;
    return ends_with_force && force < 0 ? Real(0) : force;
  }

  /// [J] in the spring.
  HOST_DEVICE double energy(Real overlap) const {
    const double d = double(overlap);
    return is_hertz ? 0.4 * double(stiffness) * d * d * std::sqrt(d) : 0.5 * double(stiffness) * d * d;
  }

  static constexpr Real kRootOf5 = Real(2.2360679774997896964);
};

/// The force on the second of two bodies; the force on the first is opposite.
template <class V>
struct PairForce {
  using Real = Scalar<V>;
  PenaltyLaw<Real> law;
  BodiesView<V> bodies;
  Box<V> box;

  /// [N] 0 if they do not touch. `along` is its component along the line of centres.
  HOST_DEVICE V operator()(const Pair& pair, Real& along) const {
    const V d = box.displacement(bodies.position[pair.i], bodies.position[pair.j]);
    const Real radii = bodies.radius[pair.i] + bodies.radius[pair.j], squared = dot(d, d);
    along = 0;
    if (!(squared <= radii * radii)) return V{};
    const V v = bodies.velocity[pair.j] - bodies.velocity[pair.i];
    const Real mass = 1 / (bodies.inverse_mass[pair.i] + bodies.inverse_mass[pair.j]);
    const Real distance = std::sqrt(squared), dashpot = law.dashpot(law.damping, mass);
    if (!(distance > 0)) {  // if centres coincide, they part along the last axis
      V force{};
      force[kDimensions<V> - 1] = along = law.force(dashpot, radii, v[kDimensions<V> - 1]);
      return force;
    }
    const Real separation = dot(v, d) / distance;
    along = law.force(dashpot, radii - distance, separation);
    V force = d * (along / distance);
    if (law.shear > 0) force -= (v - d * (separation / distance)) * law.shear;
    return force;
  }
};

}  // namespace ballpit
