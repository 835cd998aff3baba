// SPDX-License-Identifier: MIT
// One coordinate between two walls, against closed forms.
#include <catch2/catch.hpp>

#include "world/swept_drift.h"

using namespace ballpit;

namespace {

constexpr double kG = 9.81;

struct State {
  double position, velocity, given;
  int64_t hits;
};

State flown(const BetweenWalls<double>& walls, double position, double velocity, double duration) {
  const Bounces<double> bounces = walls.fly(position, velocity, duration);
  return {position, velocity, bounces.given, static_cast<int64_t>(bounces.hits)};
}

}  // namespace

TEST_CASE("a ball flies on its parabola until it meets a wall") {
  const State end = flown({0, 2, -kG, 0.5}, 1, 0.5, 0.25);
  CHECK(end.position == Approx(1 + 0.5 * 0.25 - kG * 0.25 * 0.25 / 2));
  CHECK(end.velocity == Approx(0.5 - kG * 0.25));
  CHECK(end.given == 0);
}

TEST_CASE("a bouncing ball of e = 0.8 follows its closed form through one long step, and comes to rest") {
  // From h = 1: t_n = t1·(1 + 2e(1 − e^(n−1))/(1 − e)); it rests after t1·(1 + e)/(1 − e) = 4.0637 s.
  const BetweenWalls<double> walls{0, 2, -kG, 0.8};
  const double t1 = std::sqrt(2 / kG), speed = kG * t1;
  for (const double t : {1.0, 2.0, 3.0, 4.0}) {
    double start = t1, up = 0.8 * speed;
    while (start + 2 * up / kG < t) {
      start += 2 * up / kG;
      up *= 0.8;
    }
    const State end = flown(walls, 1, 0, t);
    CHECK(end.velocity == Approx(up - kG * (t - start)).margin(1e-9));
    CHECK(end.position == Approx(up * (t - start) - kG * (t - start) * (t - start) / 2).margin(1e-9));
  }
  const State rest = flown(walls, 1, 0, 4.07);
  CHECK(rest.position == 0);
  CHECK(rest.velocity == 0);
  CHECK(rest.given == Approx(kG * 4.07));  // all that gravity gave
}

TEST_CASE("an elastic ball keeps its energy through any number of bounces in a step, between floor and ceiling, too") {
  for (const double high : {2.0, 0.3}) {
    for (const double v : {0.0, 3.0, -40.0}) {
      for (const double t : {0.01, 0.5, 7.0}) {
        const State end = flown({0, high, -kG, 1}, 0.2, v, t);
        INFO("ceiling " << high << ", v = " << v << ", t = " << t);
        CHECK(end.velocity * end.velocity / 2 + kG * end.position == Approx(v * v / 2 + kG * 0.2).epsilon(1e-9));
        CHECK(end.position >= 0);
        CHECK(end.position <= high);
      }
    }
  }
}

TEST_CASE("each bounce is a hit, those that end in rest are one, and what lies on a wall hits nothing") {
  const double t1 = std::sqrt(2 / kG);
  CHECK(flown({0, 2, -kG, 0.8}, 1, 0, 0.99 * t1).hits == 0);
  CHECK(flown({0, 2, -kG, 0.8}, 1, 0, 1.01 * t1).hits == 1);
  CHECK(flown({0, 2, -kG, 0.8}, 1, 0, 2.61 * t1).hits == 2);  // the second is at (1 + 2·0.8)·t1
  CHECK(flown({0, 2, -kG, 0.5}, 1, 0, 9).hits == 1);
  CHECK(flown({0, 2, -kG, 1}, 1, 0, 20 * t1).hits == 10);  // at t1, 3·t1, … 19·t1
  CHECK(flown({0, 2, 0, 1}, 1, -5, 1.01).hits == 3);       // at 0.2, 0.6 and 1 s
  CHECK(flown({0, 2, -kG, 0.5}, 0, 0, 1).hits == 0);
}

TEST_CASE("what lies on a wall, or a hair above it, stays there, and the wall carries it") {
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double gap : {0.0, 1e-12}) {
      const State end = flown({0, 1, -kG, e}, gap, 0, 0.01);
      CHECK(end.position == Approx(0).margin(2e-12));
      CHECK(std::fabs(end.velocity) < 1e-5);
      CHECK(end.given == Approx(kG * 0.01).epsilon(1e-3));
    }
  }
}
