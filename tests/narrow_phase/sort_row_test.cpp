// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>

#include "core/random.h"
#include "narrow_phase/contact_rows.h"

using namespace ballpit;

namespace {

void check(std::vector<Pair> row) {
  std::vector<Pair> expected = row;
  std::sort(expected.begin(), expected.end(), [](const Pair& a, const Pair& b) { return a.j < b.j; });
  // Guard values on both sides show writes beyond the row.
  row.insert(row.begin(), Pair{-1, -1});
  row.push_back({-2, -2});
  sort_row(row.data() + 1, static_cast<int>(row.size()) - 2);
  REQUIRE((row.front() == Pair{-1, -1} && row.back() == Pair{-2, -2}));
  REQUIRE(std::equal(expected.begin(), expected.end(), row.begin() + 1));
}

}  // namespace

TEST_CASE("rows of every length are sorted by their second body") {
  Random random(1);
  for (int length = 0; length <= 2000; length += length < 130 ? 1 : 37) {
    INFO("length " << length);
    std::vector<Pair> ascending, shuffled, few;
    for (int k = 0; k < length; ++k) {
      ascending.push_back({3, 10 + 2 * k});
      shuffled.push_back({3, static_cast<int>(random.bits() % 1000000)});
      few.push_back({3, static_cast<int>(random.bits() % 5)});
    }
    check(ascending);
    check({ascending.rbegin(), ascending.rend()});
    check(shuffled);
    check(few);
    if (length > 2) {  // sorted but for one
      std::swap(ascending.front(), ascending.back());
      check(ascending);
    }
  }
}
