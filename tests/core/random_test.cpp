// SPDX-License-Identifier: MIT
#include "core/random.h"

#include <catch2/catch.hpp>

using namespace ballpit;

TEST_CASE("random numbers are those of SplitMix64 on every platform") {
  // The first outputs of the reference implementation for seed 1234567 (prng.di.unimi.it/splitmix64.c).
  Random random(1234567);
  CHECK(random.bits() == 6457827717110365317u);
  CHECK(random.bits() == 3203168211198807973u);
  CHECK(random.bits() == 9817491932198370423u);
}

TEST_CASE("uniform numbers stay in their range and fill it") {
  Random random(1);
  double low = 1.0, high = 0.0, sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double u = random.uniform();
    REQUIRE((u >= 0.0 && u < 1.0));
    low = std::min(low, u);
    high = std::max(high, u);
    sum += u;
  }
  CHECK(low < 1e-4);
  CHECK(high > 1 - 1e-4);
  CHECK(sum / 100000 == Approx(0.5).margin(5 * 0.2887 / std::sqrt(100000.0)));
}

TEST_CASE("directions are unit vectors without a preferred side") {
  const int dimensions = GENERATE(2, 3);
  Random random(7);
  Vec3d sum(0.0), squares(0.0);
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const Vec3d d = random.direction(dimensions);
    REQUIRE(length(d) == Approx(1.0));
    sum += d;
    squares += d * d;
  }
  const double five_sigma = 5.0 / std::sqrt(double(n) * dimensions);
  CHECK(length(sum / double(n)) < 2 * five_sigma);
  CHECK(squares.x / n == Approx(1.0 / dimensions).margin(five_sigma));
  CHECK(squares.z / n == Approx(dimensions == 3 ? 1.0 / 3 : 0.0).margin(five_sigma));
}
