// SPDX-License-Identifier: MIT
// Galperin's billiard: where responses with steps begin to miscount.
#include <cmath>

#include <catch2/catch.hpp>

#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"

using namespace ballpit;

namespace {

double counted(const std::string& response, double dt, double ratio, bool is_swept = false) {
  Settings settings = settings_of(response, dt);
  settings.is_swept = is_swept;
  return collisions_counted(settings, ratio);
}

}  // namespace

TEST_CASE("the exact number of collisions has the digits of π at ratios of 100^k, and exact motion counts it at any") {
  CHECK(exact_collisions(1) == 3);
  CHECK(exact_collisions(100) == 31);
  CHECK(exact_collisions(1e4) == 314);
  CHECK(exact_collisions(1e6) == 3141);
  CHECK(exact_collisions(1e8) == 31415);
  CHECK(exact_collisions(3) == 5);  // π/atan(√(1/3)) is 6
  for (const double ratio : {1.0, 7.0, 10.0, 100.0, 1000.0, 1e4}) {
    INFO(ratio);
    CHECK(counted("event-driven", 0.5, ratio) == exact_collisions(ratio));
  }
}

TEST_CASE(
    "positions and springs count every collision with steps short against the time between two, and not with long "
    "ones") {
  for (const double ratio : {10.0, 100.0}) {
    const double exact = exact_collisions(ratio), step = safe_step(ratio);
    INFO(ratio);
    CHECK(counted("position-based", 0.2 * step, ratio) == exact);
    CHECK(counted("impulse", 0.2 * step, ratio, true) == exact);
    CHECK(counted("penalty", 0.1 * step, ratio) == exact);
    CHECK(counted("penalty", 0.5 * step, ratio) != exact);
  }
  CHECK(counted("position-based", 5 * safe_step(100), 100) < 31);
}

TEST_CASE("impulses count every collision until the light ball moves by its radius in a step, and leaves") {
  for (const double ratio : {100.0, 1e3, 1e4}) {
    INFO(ratio);
    CHECK(counted("impulse", 0.9 * leaving_step(ratio), ratio) == exact_collisions(ratio));
    CHECK(std::isinf(counted("impulse", 2 * leaving_step(ratio), ratio)));
  }
  CHECK(leaving_step(1e4) > 20 * safe_step(1e4));
}

TEST_CASE("the kinematic response does not push a ball at rest, and so counts one collision") {
  CHECK(counted("kinematic", 1e-3, 100) == 1);
}
