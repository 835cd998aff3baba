// SPDX-License-Identifier: MIT
// A stack and a heap far from the origin.
#include <catch2/catch.hpp>

#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"

using namespace ballpit;

namespace {

FarHeaps at(double x, const std::string& response, Precision precision) {
  Settings settings = settings_of(response, response == "penalty" ? 1.0 / 2400 : 1.0 / 240);
  settings.precision = precision;
  settings.solver = Solver::gauss_seidel;
  if (response == "impulse") settings.iterations = 16;
  return heaps_at(x, settings);
}

}  // namespace

TEST_CASE("in double precision a stack and a heap lie right a thousand kilometres away", "[slow]") {
  for (const char* response : {"impulse", "penalty", "position-based"}) {
    INFO(response);
    const FarHeaps far = at(1e6, response, Precision::float64);
    CHECK_FALSE(far.fails());
    CHECK(far.overlap < 0.03);
    CHECK(far.height_error < (response == std::string("impulse") ? 0.01 : 1e-8));
  }
}

TEST_CASE("in single precision they lie right near the origin, and fail a thousand kilometres away", "[slow]") {
  for (const char* response : {"impulse", "penalty", "position-based"}) {
    INFO(response);
    CHECK_FALSE(at(10, response, Precision::float32).fails());
    CHECK(at(1e6, response, Precision::float32).fails());
  }
  CHECK_FALSE(at(3e4, "impulse", Precision::float32).fails());
}
