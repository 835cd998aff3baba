// SPDX-License-Identifier: MIT
// The motion of a contact in units of its spring: ẍ + 2ζẋ + x = 0, x(0) = 0, ẋ(0) = 1, so x = exp(−ζt)·sin(ωt)/ω with ω
// = √(1−ζ²). The overlap ends at ωt = π. The force, −ẍ, ends at ωt = π − 2·asin ζ = 2·acos ζ, where ẋ = −exp(−ζt).
#include "response/damping.h"

#include <algorithm>
#include <cmath>

namespace ballpit {

double restitution_to_overlap_end(double zeta) {
  return zeta < 1 ? std::exp(-M_PI * zeta / std::sqrt(1 - zeta * zeta)) : 0.0;
}

double restitution_to_force_end(double zeta) {
  if (zeta == 1) return std::exp(-2.0);
  const double angle =
      zeta < 1 ? std::acos(zeta) / std::sqrt(1 - zeta * zeta) : std::acosh(zeta) / std::sqrt(zeta * zeta - 1);
  return std::exp(-2 * zeta * angle);
}

double damping_of(double restitution, bool ends_with_force) {
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

}  // namespace ballpit
