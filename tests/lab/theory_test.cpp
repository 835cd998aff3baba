// SPDX-License-Identifier: MIT
// Closed forms against published digits, or digits verified by an independent computation.
#include "measure/theory.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace ballpit;

TEST_CASE("the equation of state and its correction for few spheres have the published digits") {
  struct Row {
    double rho, carnahan_starling, reference, size_effect, rate;
  };
  const Row row = GENERATE(Row{0.1, 1.239666, 1.239720, -0.205, 0.81149}, Row{0.3, 1.966711, 1.968230, -0.603, 3.27759},
                           Row{0.5, 3.262431, 3.269410, -1.021, 7.68227}, Row{0.7, 5.710209, 5.726960, -1.511, 16.0014},
                           Row{0.9, 10.74613, 10.76274, -2.168, 33.0482});
  CHECK(carnahan_starling_z(row.rho) == Approx(row.carnahan_starling).epsilon(1e-6));
  CHECK(reference_z(row.rho) == Approx(row.reference).epsilon(1e-6));
  CHECK(1e4 * (finite_z(row.rho, 1e4) - reference_z(row.rho)) == Approx(row.size_effect).margin(0.001));
  CHECK(collision_rate(row.rho, 1e9) == Approx(row.rate).epsilon(1e-5));
}

TEST_CASE("late contacts lower the pressure by 11.56·dt at a density of a half") {
  CHECK((late_contact_z(0.5, 1e9, 1e-4) - reference_z(0.5)) / 1e-4 == Approx(-11.56).margin(0.02));
}

TEST_CASE("the recall of small cells agrees with its closed form from 1/√2 to 1") {
  for (const double c : {0.75, 0.9, 1.0})
    CHECK(cell_recall(c) == Approx(1 - 3 * (1 - c) * (1 - c) / (2 * c)).margin(1e-5));
  CHECK(cell_recall(0.5) == Approx(0.2905).margin(2e-4));
  CHECK(cell_recall(1.5) == 1);
}

TEST_CASE("over all impact parameters 1 − s²/12 of hits are found, and 4/(3s) beyond s = 2") {
  for (const double step : {0.5, 1.5, 2.0, 3.0}) {
    double mean = 0;
    constexpr int kRings = 20000;
    for (int k = 0; k < kRings; ++k) mean += part_seen(step, std::sqrt((k + 0.5) / kRings)) / kRings;
    CHECK(mean == Approx(step <= 2 ? 1 - step * step / 12 : 4 / (3 * step)).epsilon(1e-5));
  }
}

TEST_CASE("a bouncing ball is on the floor, at its tops and at rest at the times of the closed form") {
  const auto height = [](double time) { return bouncing_height(1, 0.8, 9.81, time); };
  CHECK(height(0) == 1);
  for (const double touch : {0.451523641, 1.173961467, 2.584160102}) CHECK(height(touch) == Approx(0).margin(1e-8));
  CHECK(height((0.451523641 + 1.173961467) / 2) == Approx(0.64));
  CHECK(height(4.0637) > 0);
  CHECK(height(4.063713) == 0);
}

TEST_CASE("a column of points has two fifths of its energy in its height, one of spheres a little more") {
  CHECK(barometric_height(2.5, 1, 0, 1) == Approx(1));
  CHECK(barometric_height(5, 4, 0, 1) == Approx(0.5));
  // β = 0.01: kT = 2·2.5/5.01
  const double diameter = std::cbrt(3 / (2 * M_PI)), per_area = 0.01 * 2 * 2.5 / 5.01;
  CHECK(barometric_height(2.5, 1, diameter, per_area) == Approx(2 * 2.5 / 5.01 * 1.005).epsilon(1e-9));
}

TEST_CASE("the height of the column agrees with hydrostatics to second order of the density") {
  // dP/dy = −w·n with P = kT·(n + B·n²): y(n) = H·(ln(n₀/n) + 2B·(n₀ − n)), H = kT/w.
  constexpr double kT = 1.3, kWeight = 2.1, kDiameter = 0.5, kFloor = 0.12, kH = kT / kWeight;
  const double b = 2 * M_PI / 3 * std::pow(kDiameter, 3), per_area = kH * (kFloor + b * kFloor * kFloor);
  double moment = 0;
  constexpr int kSlices = 100'000;
  for (int k = 0; k < kSlices; ++k) {
    const double dn = kFloor / kSlices, n = (k + 0.5) * dn;
    moment += kH * (std::log(kFloor / n) + 2 * b * (kFloor - n)) * n * kH * (1 / n + 2 * b) * dn;
  }
  const double height = moment / per_area, beta = b * kFloor;
  CHECK(beta > 0.03);
  CHECK(barometric_height(1.5 * kT + kWeight * height, kWeight, kDiameter, per_area) ==
        Approx(height).epsilon(beta * beta));
  CHECK(std::fabs(barometric_height(1.5 * kT + kWeight * height, kWeight, 0, per_area) / height - 1) > 5 * beta * beta);
}

TEST_CASE("springs, sweeps and rounding have their limits") {
  CHECK(contact_duration(1e4, 0.5, 0) == Approx(M_PI * std::sqrt(0.5e-4)));
  CHECK(contact_duration(stiffness_of_duration(0.02, 0.5, 0.3), 0.5, 0.3) == Approx(0.02));
  CHECK(stack_sweeps(20) == Approx(746.4));
  CHECK(ratio_sweeps(300) == Approx(4.6 * 301).epsilon(0.01));
  CHECK(frozen_step(65536) == Approx(0.00390625));  // 0.2 m/s at 60 steps a second is less
}
