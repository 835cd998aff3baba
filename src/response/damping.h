// SPDX-License-Identifier: MIT
// How much a dashpot must damp, so that a free hit has the restitution asked for: ζ = c / (2·√(k·m*)), for linear and
// Hertz contacts alike (penalty.h).
#pragma once

namespace ballpit {

/// Restitution of a contact with this ζ ≥ 0 that ends where the overlap does: exp(−πζ/√(1−ζ²)), 0 from ζ = 1 on.
double restitution_to_overlap_end(double zeta);

/// … or where the force would begin to pull: exp(−2ζ·acos ζ/√(1−ζ²)), with acosh ζ/√(ζ²−1) from ζ = 1 on.
double restitution_to_force_end(double zeta);

/// ζ for a restitution from 0 to 1. Full damping cannot be had from a spring and a dashpot: where e is below
/// kLeastRestitution, ζ is what makes it kLeastRestitution.
double damping_of(double restitution, bool ends_with_force);

inline constexpr double kLeastRestitution = 0.01;

}  // namespace ballpit
