// SPDX-License-Identifier: MIT
#include "exec/cpu_executor.h"

#include <atomic>
#include <chrono>
#include <numeric>
#include <thread>

#include <catch2/catch.hpp>

#include "core/random.h"
#include "exec/atomics.h"
#include "exec/reduce.h"

using namespace ballpit;

namespace {

std::vector<int> random_ints(int64_t n, int limit, uint64_t seed) {
  Random random(seed);
  std::vector<int> values(static_cast<size_t>(n));
  for (int& value : values) value = static_cast<int>(random.uniform() * limit);
  return values;
}

struct SpanOf {
  std::vector<int>& values;
  operator Span<int>() const { return {values.data(), static_cast<int64_t>(values.size())}; }
  operator Span<const int>() const { return {values.data(), static_cast<int64_t>(values.size())}; }
};

struct Plus {
  HOST_DEVICE double operator()(double a, double b) const { return a + b; }
};

}  // namespace

TEST_CASE("parallel_for calls each index once") {
  const int threads = GENERATE(1, 2, 8);
  const int n = GENERATE(0, 1, 511, 513, 100000);
  CpuExecutor exec(threads);
  std::vector<int> calls(static_cast<size_t>(n), 0);
  exec.parallel_for("count", n, [&](int i) { atomic_add(&calls[static_cast<size_t>(i)], 1); });
  CHECK(std::count(calls.begin(), calls.end(), 1) == n);
}

TEST_CASE("eight threads run at once, even on fewer cores") {
  CpuExecutor exec(8);
  std::atomic<int> here{0};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  std::atomic<int> most{0};
  exec.parallel_for("meet", 8 * 512, [&](int) {
    thread_local bool counted = false;
    if (counted) return;
    counted = true;
    ++here;
    while (here < 3 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    most = std::max(most.load(), here.load());
  });
  CHECK(most >= 3);
}

TEST_CASE("launches are timed under their names") {
  CpuExecutor exec(2);
  for (int k = 0; k < 3; ++k) exec.parallel_for("a", 10, [](int) {});
  exec.parallel_for("b", 10, [](int) {});
  REQUIRE(exec.stage_times().stages().size() == 2);
  CHECK(exec.stage_times().stages()[0].name == "a");
  CHECK(exec.stage_times().stages()[0].launches == 3);
  CHECK(exec.stage_times().stages()[1].launches == 1);
}

TEST_CASE("exclusive scan gives each element the sum of those before it") {
  const int threads = GENERATE(1, 2, 8);
  const int n = GENERATE(0, 1, 1000, 16384, 16385, 200000);
  CpuExecutor exec(threads);
  std::vector<int> counts = random_ints(n, 100, 3), offsets(counts.size() + 1, -1);
  const int64_t total = exec.exclusive_scan("scan", SpanOf{counts}, SpanOf{offsets});
  int sum = 0;
  for (size_t i = 0; i < counts.size(); ++i) {
    REQUIRE(offsets[i] == sum);
    sum += counts[i];
  }
  CHECK(offsets.back() == sum);
  CHECK(total == sum);
}

TEST_CASE("exclusive scan reports totals beyond 32 bits") {
  CpuExecutor exec(1);
  std::vector<int> counts(3, 2000000000), offsets(4);
  CHECK(exec.exclusive_scan("scan", SpanOf{counts}, SpanOf{offsets}) == 6000000000);
}

TEST_CASE("sorting pairs by key is stable") {
  const int threads = GENERATE(1, 2, 8);
  const int n = GENERATE(0, 1, 8192, 8193, 100000);
  CpuExecutor exec(threads);
  std::vector<int> keys = random_ints(n, 50, 5), values(keys.size());
  std::iota(values.begin(), values.end(), 0);
  const std::vector<int> original = keys;
  exec.sort_pairs("sort", Span<int>(SpanOf{keys}), Span<int>(SpanOf{values}));
  for (size_t i = 0; i < keys.size(); ++i) REQUIRE(keys[i] == original[static_cast<size_t>(values[i])]);
  for (size_t i = 1; i < keys.size(); ++i) {
    REQUIRE((keys[i - 1] < keys[i] || (keys[i - 1] == keys[i] && values[i - 1] < values[i])));
  }
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

TEST_CASE("exchange hands each value on exactly once, however many threads swap") {
  CpuExecutor exec(8);
  const int n = 20000;
  int head = -1;
  std::vector<int> next(n, -2);
  exec.parallel_for("link", n, [&](int i) { next[static_cast<size_t>(i)] = atomic_exchange(&head, i); });
  int length = 0;
  for (int i = head; i != -1; i = next[static_cast<size_t>(i)]) ++length;
  CHECK(length == n);
}

TEST_CASE("a buffer grows and spans what was asked for") {
  HostBuffer<int> buffer;
  CHECK(buffer.span().empty());
  buffer.resize(10);
  buffer.span()[9] = 4;
  buffer.resize(5);
  CHECK(buffer.size() == 5);
}
