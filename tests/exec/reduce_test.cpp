// SPDX-License-Identifier: MIT
#include "exec/reduce.h"

#include <numeric>

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"
#include "tests/exec/arrays.h"

using namespace ballpit;

namespace {

struct Plus {
  template <class T>
  T operator()(const T& a, const T& b) const {
    return a + b;
  }
};

/// A combination that shows the order of its operands.
struct Range {
  int first = 0, last = -1;
  bool is_broken = false;
};
struct JoinRanges {
  Range operator()(const Range& a, const Range& b) const {
    if (a.last < a.first) return b;
    if (b.last < b.first) return a;
    return {a.first, b.last, a.is_broken || b.is_broken || a.last + 1 != b.first};
  }
};

}  // namespace

TEST_CASE("reduce combines each value once, in the order of the indices") {
  const int threads = GENERATE(1, 2, 8);
  const int n = GENERATE(1, 2, 63, 64, 65, 4096, 4097, 64 * 64 * 64 + 1);
  CpuExecutor exec(threads);
  const Range all = reduce(
      exec, "join", n, Range{},
      [](int i) {
        return Range{i, i, false};
      },
      JoinRanges{});
  CHECK(all.first == 0);
  CHECK(all.last == n - 1);
  CHECK_FALSE(all.is_broken);
}

TEST_CASE("nothing reduces to the identity") {
  CpuExecutor exec(2);
  CHECK(reduce(
            exec, "sum", 0, 42, [](int i) { return i; }, Plus{}) == 42);
}

TEST_CASE("a floating-point sum has the same bits for any number of threads") {
  Random random(11);
  std::vector<double> values(100003);
  for (double& value : values) value = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-8, 8));
  const auto sum = [&](int threads) {
    CpuExecutor exec(threads);
    return reduce(
        exec, "sum", static_cast<int64_t>(values.size()), 0.0, [&](int i) { return values[static_cast<size_t>(i)]; },
        Plus{});
  };
  const double one = sum(1);
  CHECK(one == Approx(std::accumulate(values.begin(), values.end(), 0.0)));
  CHECK(sum(2) == one);
  CHECK(sum(8) == one);
}

TEST_CASE("reductions of different types and lengths follow each other in the same scratch memory") {
  CpuExecutor exec(2);
  for (const int n : {100000, 10, 5000}) {
    CHECK(reduce(
              exec, "sum", n, int64_t{0}, [](int i) { return int64_t{i}; }, Plus{}) == int64_t{n} * (n - 1) / 2);
    CHECK(reduce(
              exec, "sum", n, 0.0, [](int) { return 0.5; }, Plus{}) == n * 0.5);
  }
}

TEST_CASE("any finds one index among many, and none") {
  const int threads = GENERATE(1, 2, 8);
  CpuExecutor exec(threads);
  for (const int only : {0, 511, 512, 99999}) {
    CHECK(any(exec, "find", 100000, [only](int i) { return i == only; }));
    CHECK_FALSE(any(exec, "find", only, [only](int i) { return i == only; }));
  }
  CHECK(any(exec, "find", 100000, [](int) { return true; }));
}
