// SPDX-License-Identifier: MIT
// The damping ratio ζ = c / (2·√(k·m*)) of a dashpot that gives a collision the wanted restitution, for linear and
// Hertz contacts alike (penalty.h).
#pragma once

namespace ballpit {

/// Restitution for ζ ≥ 0 if a contact ends when the overlap does: exp(−πζ/√(1−ζ²)), 0 from ζ = 1 on.
double restitution_to_overlap_end(double zeta);

/// The same if it ends when the force would begin to pull: exp(−2ζ·acos ζ/√(1−ζ²)), with acosh ζ/√(ζ²−1) from ζ = 1 on.
double restitution_to_force_end(double zeta);

/// ζ for a restitution from 0 to 1. A spring with a dashpot cannot reach restitution 0, so values below kMinRestitution
/// count as kMinRestitution.
double damping_of(double restitution, bool ends_with_force);

inline constexpr double kMinRestitution = 0.01;

}  // namespace ballpit
