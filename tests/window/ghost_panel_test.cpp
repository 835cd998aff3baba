// SPDX-License-Identifier: MIT
// The exact ghost in the panel: its switch, its figures, its curve, and why there is none.
#include <catch2/catch.hpp>

#include "tests/support/desk.h"

using namespace ballpit;

TEST_CASE("the ghost is switched on by its overlay, and its figures and curve are among the numbers") {
  Desk desk("lecture-grid");
  CHECK_FALSE(desk.has("ghost curve"));
  desk.click("overlay ghost");
  CHECK(desk.has("row median distance"));
  CHECK_FALSE(desk.has("ghost curve"));  // without a past
  for (int k = 0; k < 200; ++k) desk.demo.step();
  desk.rest();
  CHECK(desk.has("ghost curve"));
  CHECK(desk.has("row first wrong collision"));
  CHECK_FALSE(desk.has("row Lyapunov's exponent"));  // known in space only
  desk.click("overlay ghost");
  CHECK_FALSE(desk.has("ghost curve"));
}

TEST_CASE("the panel gives Lyapunov's exponent of a gas") {
  Desk desk("gas-dense");
  desk.click("overlay ghost");
  for (int k = 0; k < 20; ++k) desk.demo.step();
  desk.rest();
  CHECK(desk.has("row Lyapunov's exponent"));
}

TEST_CASE("the panel says why there is no ghost") {
  Desk desk("stack");
  desk.click("overlay ghost");
  for (int k = 0; k < 20; ++k) desk.demo.step();
  desk.rest();
  CHECK(desk.has("lack of ghost"));
}

TEST_CASE("the curve in the panel has ink where the distance has grown") {
  Desk desk("lecture-grid");
  desk.click("overlay ghost");
  for (int k = 0; k < 1200; ++k) desk.demo.step();
  desk.rest();
  REQUIRE(desk.has("ghost curve"));
  desk.rest();
  const ItemRect rect = desk.panel.items().at("ghost curve");
  const Image image = desk.renderer.read_pixels();
  int columns = 0;
  const int left = int(rect.low.x + 0.35f * (rect.high.x - rect.low.x)), right = int(rect.high.x) - 14;
  for (int x = left; x < right; ++x) {
    int dark = 0;
    for (int y = int(rect.low.y) + 8; y < int(rect.low.y + 0.8f * (rect.high.y - rect.low.y)); ++y) {
      const uint8_t* pixel = image.pixel(x, y);
      dark += pixel[0] < 90 && pixel[1] < 90 && pixel[2] < 90;
    }
    columns += dark > 0;
  }
  CHECK(columns > 0.9 * (right - left));
}
