// SPDX-License-Identifier: MIT
#include "measure/theory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ballpit {

namespace {

using std::numbers::pi;

/// P = ρZ.
double pressure(double rho) { return rho * reference_z(rho); }

}  // namespace

double carnahan_starling_z(double rho) {
  const double eta = pi * rho / 6;
  return (1 + eta + eta * eta - eta * eta * eta) / std::pow(1 - eta, 3);
}

double reference_z(double rho) {
  struct Term {
    double factor;
    int power;
  };
  constexpr Term kTerms[] = {{4, 1},          {6, 2},          {2.3647684, 3},   {-0.8698551, 4},   {1.1062803, 5},
                             {-1.1014221, 6}, {0.66605866, 7}, {-0.03633431, 8}, {-0.20965164, 10}, {0.10555569, 14},
                             {-0.0087238, 22}};
  const double eta = pi * rho / 6, x = eta / (1 - eta);
  double z = 1;
  for (const Term& term : kTerms) z += term.factor * std::pow(x, term.power);
  return z;
}

double finite_z(double rho, double count) {
  constexpr double h = 1e-4;  // both differences are accurate to 1e-6
  const double slope = (pressure(rho + h) - pressure(rho - h)) / (2 * h);
  const double curvature = (pressure(rho + h) - 2 * pressure(rho) + pressure(rho - h)) / (h * h);
  return reference_z(rho) - rho * curvature / (2 * slope * count);
}

double late_contact_z(double rho, double count, double dt) {
  const double diameter = 1 - std::sqrt(pi) / 2 * dt;
  return finite_z(rho * diameter * diameter * diameter, count);
}

double collision_rate(double rho, double count) {
  const double freedom = 3 * (count - 1);
  const double speeds = std::exp(std::lgamma(freedom / 2) - std::lgamma((freedom + 1) / 2)) * std::sqrt(freedom / 2);
  return 6 / std::sqrt(pi) * (finite_z(rho, count) - 1) * speeds;
}

double cooling_time(double rho, double count, double restitution) {
  return 6 / ((1 - restitution * restitution) * collision_rate(rho, count));
}

double barometric_height(double energy, double weight, double diameter, double per_area) {
  const double volume = 2 * pi / 3 * diameter * diameter * diameter;
  double kt = 0.4 * energy, beta = 0;
  for (int k = 0; k < 20; ++k) {  // each pass reduces the error by a factor of β
    beta = volume * per_area * weight / kt;
    kt = 2 * energy / (5 + beta);
  }
  return kt / weight * (1 + beta / 2);
}

double bouncing_height(double height, double restitution, double gravity, double time) {
  const double fall = std::sqrt(2 * height / gravity);
  if (time <= fall) return height - gravity * time * time / 2;
  double speed = restitution * gravity * fall, since = time - fall;
  for (; since > 2 * speed / gravity; speed *= restitution) {
    since -= 2 * speed / gravity;
    if (speed < 1e-9 * gravity * fall) return 0;
  }
  return speed * since - gravity * since * since / 2;
}

double contact_duration(double stiffness, double mu, double zeta) {
  return pi / std::sqrt(stiffness / mu * (1 - zeta * zeta));
}

double stiffness_of_duration(double duration, double mu, double zeta) {
  return mu * pi * pi / (duration * duration * (1 - zeta * zeta));
}

double hertz_duration(double stiffness, double mu, double v) {
  return 2.943275 * std::pow(5 * mu * v * v / (4 * stiffness), 0.4) / v;
}

double part_seen(double step, double impact) { return std::min(1.0, 2 * std::sqrt(1 - impact * impact) / step); }

double cell_recall(double edge) {
  // Over an octant: z uniform in [0, 1] and an angle in [0, π/2], by the midpoint rule.
  constexpr int kPoints = 400;
  const auto part = [edge](double d) { return std::clamp(2 - d / edge, 0.0, 1.0); };
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double z = (i + 0.5) / kPoints, across = std::sqrt(1 - z * z);
    for (int j = 0; j < kPoints; ++j) {
      const double angle = (j + 0.5) / kPoints * pi / 2;
      sum += part(z) * part(across * std::cos(angle)) * part(across * std::sin(angle));
    }
  }
  return sum / (kPoints * kPoints);
}

double stack_sweeps(double n) { return 1.866 * n * n; }

double ratio_sweeps(double ratio) { return std::log(100.0) / std::log1p(1 / ratio); }

double frozen_step(double x) {
  const auto at = static_cast<float>(x);
  return 0.5 * (double(std::nextafter(at, std::numeric_limits<float>::infinity())) - double(at));
}

}  // namespace ballpit
