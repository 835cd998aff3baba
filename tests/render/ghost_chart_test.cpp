// SPDX-License-Identifier: MIT
// The curve of the distance from exact motion.
#include "render/ghost_chart.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/in_german.h"

using namespace ballpit;

namespace {

/// Grows from 1e-10 radii by a factor of ten each second, over 8 s.
GhostInspection growing() {
  GhostInspection ghost;
  ghost.dropped = 2;
  for (int k = 0; k <= 80; ++k) {
    const double median = k == 0 ? 0 : std::pow(10.0, -10 + 0.1 * k);
    ghost.curve.push_back({2 + 0.1 * k, median, 50 * median});
  }
  return ghost;
}

}  // namespace

TEST_CASE("the chart reaches from the smallest distance to at least one radius, and over the time since the drop") {
  const GhostChart chart = chart_of(growing());
  CHECK(chart.low == -10);
  CHECK(chart.high == 0);
  CHECK(chart.from == 2);
  CHECK(chart.to == Approx(10));
  REQUIRE(chart.median.size() == 80);  // 0 has no place on the axis before anything has moved
  CHECK(chart.median.front().x == Approx(0.1 / 8));
  CHECK(chart.median.front().y == Approx(0.01));
  CHECK(chart.median.back().x == 1);
  CHECK(chart.median.back().y == Approx(0.8));
  CHECK(chart.largest.back().y == Approx(0.8 + std::log10(50.0) / 10));
  CHECK_FALSE(chart.growth);
  CHECK_FALSE(chart.wrong);
}

TEST_CASE("Lyapunov's line has the slope of the exponent and begins at the median") {
  GhostInspection ghost = growing();
  ghost.growth = std::log(10.0);  // a factor of ten each second
  ghost.growth_from = 4;
  GhostChart chart = chart_of(ghost);
  REQUIRE(chart.growth);
  const auto [from, to] = *chart.growth;
  CHECK(from.x == Approx(0.25).margin(0.013));
  CHECK(from.y == Approx(0.2).margin(0.011));
  CHECK(to.x == 1);
  CHECK(to.y == Approx(0.8).margin(1e-4));  // along the curve
  ghost.growth *= 2;                        // now it ends at the top
  chart = chart_of(ghost);
  REQUIRE(chart.growth);
  CHECK((*chart.growth)[1].y == Approx(1));
  CHECK((*chart.growth)[1].x < 0.8);
}

TEST_CASE("the first wrong collision has its time in the chart") {
  GhostInspection ghost = growing();
  ghost.wrong = WrongCollision{Timing::late, 4, 0.001, 7, 3, {}};
  CHECK(*chart_of(ghost).wrong == Approx(0.25));
}

TEST_CASE("a chart without a past is empty") {
  GhostInspection ghost;
  ghost.curve = {{0, 0, 0}};
  const GhostChart chart = chart_of(ghost);
  CHECK(chart.median.empty());
  CHECK(chart.largest.empty());
  CHECK(chart.height_of(0) == 0);
  CHECK(chart.height_of(1e9) == 1);
}

TEST_CASE("a wrong collision is described in the language set") {
  WrongCollision wrong{Timing::late, 0.53, 0.0021, 17, 3, {}};
  CHECK(timing_text(wrong) == "late by 2.10 ms");
  CHECK(bodies_text(wrong) == "spheres 3 and 17");
  CHECK(time_text(wrong.time) == "t = 0.53 s");
  CHECK(time_text(8.4e-5) == "t = 84.0 µs");
  wrong.late_by = -0.0021;
  wrong.timing = Timing::early;
  wrong.partner = -1;
  CHECK(timing_text(wrong) == "early by 2.10 ms");
  CHECK(bodies_text(wrong) == "sphere 17 and a wall");
  wrong.timing = Timing::missed;
  CHECK(timing_text(wrong) == "never came");
  wrong.timing = Timing::open;
  CHECK(timing_text(wrong) == "has not come yet");
  const InGerman in_german;
  CHECK(time_text(wrong.time) == "t = 0,53 s");
  wrong.timing = Timing::late;
  CHECK(timing_text(wrong) == "um 2,10 ms zu spät");
}
