// SPDX-License-Identifier: MIT
#include "exec/cpu_executor.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <catch2/catch.hpp>

#include "exec/atomics.h"
#include "tests/exec/arrays.h"

using namespace ballpit;

TEST_CASE("parallel_for calls each index once") {
  const int threads = GENERATE(1, 2, 8);
  const int n = GENERATE(0, 1, 511, 512, 513, 100000);
  CpuExecutor exec(threads);
  std::vector<int> calls(static_cast<size_t>(n), 0);
  exec.parallel_for("count", n, [&](int i) { ++std::atomic_ref<int>(calls[static_cast<size_t>(i)]); });
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

TEST_CASE("parallel_for_blocks calls each block once") {
  const int threads = GENERATE(1, 2, 8);
  const int blocks = GENERATE(0, 1, 2, 7, 300);
  CpuExecutor exec(threads);
  std::vector<int> calls(static_cast<size_t>(blocks), 0);
  exec.parallel_for_blocks("count", blocks, [&](int64_t b) { ++std::atomic_ref<int>(calls[static_cast<size_t>(b)]); });
  CHECK(std::count(calls.begin(), calls.end(), 1) == blocks);
  CHECK(exec.stage_times().stages().at(0).launches == 1);
}

TEST_CASE("few blocks run at once too, unlike few kernels") {
  CpuExecutor exec(2);
  std::atomic<int> here{0};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  exec.parallel_for_blocks("meet", 2, [&](int64_t) {
    ++here;
    while (here < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
  });
  CHECK(std::chrono::steady_clock::now() < deadline);
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
  std::vector<int> counts = random_values<int>(n, 100, 3), offsets(counts.size() + 1, -1);
  const int64_t total = exec.exclusive_scan("scan", Span<const int>(span_of(counts)), span_of(offsets));
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
  CHECK(exec.exclusive_scan("scan", Span<const int>(span_of(counts)), span_of(offsets)) == 6000000000);
}

TEST_CASE("fill sets every element and no other") {
  const int threads = GENERATE(1, 8);
  const int n = GENERATE(0, 1, 513, 10000);
  CpuExecutor exec(threads);
  std::vector<int> values(static_cast<size_t>(n) + 1, 7);
  exec.fill("clear", Span<int>(values.data(), n), -1);
  CHECK(std::count(values.begin(), values.end(), -1) == n);
  CHECK(values.back() == 7);
}

TEST_CASE("what is uploaded comes down again") {
  CpuExecutor exec(2);
  HostBuffer<int> buffer;
  const std::vector<int> values = random_values<int>(1000, 100, 1);
  exec.upload(buffer, values);
  CHECK(exec.download(buffer.span()) == values);
  exec.upload(buffer, values.data() + 10, 5);  // less than it holds already
  CHECK(exec.download(buffer.span()) == std::vector<int>(values.begin() + 10, values.begin() + 15));
  exec.upload(buffer, std::vector<int>{});
  CHECK(exec.download(buffer.span()).empty());
}

TEST_CASE("scratch memory is large enough and aligned for any type, and the two do not overlap") {
  CpuExecutor exec(2);
  struct alignas(16) Wide {
    double values[4];
  };
  const Span<Wide> wide = exec.scratch<Wide>(0, 1001);
  const Span<char> narrow = exec.scratch<char>(1, 17);
  CHECK(wide.size() == 1001);
  CHECK(narrow.size() == 17);
  CHECK(reinterpret_cast<uintptr_t>(wide.data()) % alignof(Wide) == 0);
  for (Wide& w : wide) w = {{1, 2, 3, 4}};
  for (char& c : narrow) c = 'x';
  CHECK(std::all_of(wide.begin(), wide.end(), [](const Wide& w) { return w.values[0] == 1 && w.values[3] == 4; }));
  CHECK(std::all_of(narrow.begin(), narrow.end(), [](char c) { return c == 'x'; }));
}

TEST_CASE("scratch memory is kept from call to call") {
  CpuExecutor exec(1);
  const void* const first = exec.scratch<double>(0, 1000).data();
  CHECK(exec.scratch<char>(0, 1000).data() == first);
  CHECK(exec.scratch<double>(0, 1000).data() == first);
}
