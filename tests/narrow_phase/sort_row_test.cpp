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

TEST_CASE("the rows of all bodies are sorted, short and long ones, on any number of threads") {
  const int longest = GENERATE(1, 2, 5, 48, 300), threads = GENERATE(1, 4);
  Random random(7);
  const auto below = [&](int limit) { return static_cast<int>(random.bits() % static_cast<unsigned>(limit)); };
  constexpr int kBodies = 40000;
  std::vector<Pair> pairs;
  ContactRows<CpuExecutor> rows;
  rows.resize(kBodies, 0);
  for (int i = 0; i < kBodies; ++i) {
    rows.first()[i] = static_cast<int>(pairs.size());
    for (int k = below(2) * below(below(100) == 0 ? longest + 1 : std::min(longest, 5) + 1); k > 0; --k) {
      pairs.push_back({i, i + 1 + below(1000000)});
    }
  }
  rows.first()[kBodies] = static_cast<int>(pairs.size());
  rows.resize_pairs(static_cast<int64_t>(pairs.size()));
  std::copy(pairs.begin(), pairs.end(), rows.pairs().begin());
  CpuExecutor exec(threads);
  sort_rows(exec, kBodies, rows);
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& a, const Pair& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; });
  REQUIRE(exec.download(rows.pairs()) == pairs);
}
