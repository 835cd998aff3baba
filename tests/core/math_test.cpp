// SPDX-License-Identifier: MIT
#include "core/math.h"

#include <catch2/catch.hpp>

using namespace ballpit;

TEST_CASE("rounding to float and back rounds every component") {
  // GCC 12.2 returns unrounded numbers when it vectorises the neighbouring conversions.
  volatile double tenth = 0.1;  // not known to the compiler
  const Vec3d exact(tenth, 3 * tenth, 7 * tenth);
  const Vec3d rounded = widen(narrow<Vec3>(exact)), converted = Vec3d(Vec3(exact));
  for (int axis = 0; axis < 3; ++axis) {
    volatile float alone = static_cast<float>(exact[axis]);
    CHECK(rounded[axis] == static_cast<double>(alone));
    CHECK(converted[axis] == static_cast<double>(alone));
    CHECK(rounded[axis] != exact[axis]);
  }
}

TEST_CASE("narrowing to the plane drops z, widening sets it to zero") {
  CHECK(narrow<Vec2>({1, 2, 3}) == Vec2(1, 2));
  CHECK(widen(Vec2(1, 2)) == Vec3d(1, 2, 0));
}
