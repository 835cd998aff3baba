// SPDX-License-Identifier: MIT
// Medians and quartiles of measurements, and how evenly work is distributed over threads.
#include <numeric>

#include <catch2/catch.hpp>

#include "measure/statistics.h"

using namespace ballpit;

TEST_CASE("median and quartiles are interpolated between the values") {
  const Spread odd = spread_of({5, 1, 4, 2, 3});
  CHECK(odd.least == 1);
  CHECK(odd.lower == 2);
  CHECK(odd.median == 3);
  CHECK(odd.upper == 4);
  const Spread even = spread_of({4, 1, 2, 3});
  CHECK(even.lower == 1.75);
  CHECK(even.median == 2.5);
  CHECK(even.upper == 3.25);
  const Spread one = spread_of({7});
  CHECK(one.least == 7);
  CHECK(one.lower == 7);
  CHECK(one.median == 7);
  CHECK(one.upper == 7);
}

TEST_CASE("work is counted in bins of powers of two") {
  const WorkProfile profile = profile_work({0, 0, 1, 2, 3, 4, 7, 8, 1000});
  CHECK(profile.threads == 9);
  CHECK(profile.most == 1000);
  CHECK(profile.mean == Approx(1025.0 / 9));
  REQUIRE(profile.bins.size() == 11);
  const std::vector<int64_t> counts{2, 1, 2, 2, 1, 0, 0, 0, 0, 0, 1};
  for (size_t k = 0; k < counts.size(); ++k) CHECK(profile.bins[k].threads == counts[k]);
  CHECK(profile.bins[3].low == 4);
  CHECK(profile.bins[3].high == 7);
  CHECK(profile.bins[10].low == 512);
}

TEST_CASE("a warp takes as long as its longest thread") {
  CHECK(*profile_work(std::vector<int>(64, 5)).simd_efficiency == 1.0);
  std::vector<int> uneven(64, 1);
  uneven[0] = 4;  // the first warp takes 4 steps of 32 threads, the second one
  CHECK(*profile_work(uneven).simd_efficiency == Approx(67.0 / (32 * 5)));
  CHECK(*profile_work({3}).simd_efficiency == Approx(1.0 / 32));
}

TEST_CASE("without work there is no efficiency, and without threads no work") {
  CHECK_FALSE(profile_work({0, 0, 0}).simd_efficiency);
  CHECK(profile_work({0, 0, 0}).bins[0].threads == 3);
  const WorkProfile none = profile_work({});
  CHECK_FALSE(none.simd_efficiency);
  CHECK(none.threads == 0);
  CHECK(none.mean == 0);
}
