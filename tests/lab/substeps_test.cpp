// SPDX-License-Identifier: MIT
// The same work as substeps or as iterations: what a stack at rest overlaps by.
#include <catch2/catch.hpp>

#include "lab/experiments/experiments.h"

using namespace ballpit;

namespace {

double overlap(const std::vector<double>& masses, const std::string& response, int work, bool is_substeps) {
  return overlap_at_rest(masses, equal_work(response, 1.0 / 60, work, is_substeps));
}

/// g·h² [radii] of 0.1 m.
double fall(int work) { return 9.81 / (60.0 * work) / (60.0 * work) / 0.1; }

}  // namespace

TEST_CASE("by positions, n substeps leave 1/n² of the overlap, as theory says, and n iterations far more") {
  const std::vector<double> stack(20, 1.0), heavy{1.0, 100.0};
  for (const int work : {16, 32, 64}) {
    INFO(work);
    CHECK(overlap(stack, "position-based", work, true) == Approx(34 * fall(work)).epsilon(0.01));
    CHECK(overlap(heavy, "position-based", work, true) == Approx(100 * fall(work)).epsilon(0.01));
    CHECK(overlap(stack, "position-based", work, false) > 10 * 34 * fall(work));
    CHECK(overlap(heavy, "position-based", work, false) > 10 * 100 * fall(work));
  }
}

TEST_CASE("impulses keep a hundredth of a radius, however the work is spent") {
  const std::vector<double> stack(20, 1.0);
  CHECK(overlap(stack, "impulse", 128, true) == Approx(0.01).epsilon(0.02));
  CHECK(overlap(stack, "impulse", 512, false) == Approx(0.01).epsilon(0.05));
  CHECK(overlap(stack, "impulse", 32, true) < 0.5 * overlap(stack, "impulse", 32, false));
}
