// SPDX-License-Identifier: MIT
// The CUDA executor keeps the contract of the CPU executor.
#include <algorithm>
#include <numeric>

#include <catch2/catch.hpp>

#include "core/random.h"
#include "cuda_executor.h"
#include "exec/atomics.h"
#include "exec/cpu_executor.h"
#include "exec/reduce.h"

using namespace ballpit;

namespace {

std::vector<int> random_ints(int n, int limit, uint64_t seed) {
  Random random(seed);
  std::vector<int> values(static_cast<size_t>(n));
  for (int& value : values) value = static_cast<int>(random.uniform() * limit);
  return values;
}

struct CountCall {
  Span<int> calls;
  HOST_DEVICE void operator()(int i) const { atomic_add(&calls[i], 1); }
};

struct LinkAll {
  Span<int> head;
  Span<int> next;
  HOST_DEVICE void operator()(int i) const { next[i] = atomic_exchange(&head[0], i); }
};

struct ValueAt {
  Span<const double> values;
  HOST_DEVICE double operator()(int i) const { return values[i]; }
};

struct Plus {
  HOST_DEVICE double operator()(double a, double b) const { return a + b; }
};

template <class Exec>
double sum(Exec& exec, const std::vector<double>& values) {
  typename Exec::template Buffer<double> buffer;
  exec.upload(buffer, values);
  return reduce(exec, "sum", buffer.size(), 0.0, ValueAt{buffer.span()}, Plus{});
}

}  // namespace

TEST_CASE("parallel_for on CUDA calls each index once") {
  const int n = GENERATE(0, 1, 255, 257, 10000);
  CudaExecutor exec;
  DeviceBuffer<int> calls;
  calls.resize(n);
  exec.fill("clear", calls.span(), 0);
  exec.parallel_for("count", n, CountCall{calls.span()});
  const std::vector<int> result = exec.download(calls.span());
  CHECK(std::count(result.begin(), result.end(), 1) == n);
}

TEST_CASE("exclusive scan on CUDA gives each element the sum of those before it") {
  const int n = GENERATE(0, 1, 1000, 5000);
  CudaExecutor exec;
  const std::vector<int> counts = random_ints(n, 100, 3);
  DeviceBuffer<int> in, out;
  exec.upload(in, counts);
  out.resize(n + 1);
  const int64_t total = exec.exclusive_scan("scan", in.span(), out.span());
  const std::vector<int> offsets = exec.download(out.span());
  int expected = 0;
  for (int i = 0; i < n; ++i) {
    REQUIRE(offsets[i] == expected);
    expected += counts[i];
  }
  CHECK(offsets.back() == expected);
  CHECK(total == expected);
}

TEST_CASE("exclusive scan on CUDA reports totals beyond 32 bits") {
  CudaExecutor exec;
  DeviceBuffer<int> in, out;
  exec.upload(in, std::vector<int>(3, 2000000000));
  out.resize(4);
  CHECK(exec.exclusive_scan("scan", in.span(), out.span()) == 6000000000);
}

TEST_CASE("sorting pairs by key on CUDA is stable") {
  const int n = GENERATE(0, 1, 3000);
  CudaExecutor exec;
  const std::vector<int> keys = random_ints(n, 50, 5);
  std::vector<int> values(keys.size());
  std::iota(values.begin(), values.end(), 0);
  DeviceBuffer<int> key_buffer, value_buffer;
  exec.upload(key_buffer, keys);
  exec.upload(value_buffer, values);
  exec.sort_pairs("sort", key_buffer.span(), value_buffer.span());
  const std::vector<int> sorted_keys = exec.download(key_buffer.span()), order = exec.download(value_buffer.span());
  for (int i = 0; i < n; ++i) REQUIRE(sorted_keys[i] == keys[order[i]]);
  for (int i = 1; i < n; ++i) {
    REQUIRE((sorted_keys[i - 1] < sorted_keys[i] || (sorted_keys[i - 1] == sorted_keys[i] && order[i - 1] < order[i])));
  }
}

TEST_CASE("a floating-point sum has the same bits on CUDA and CPU") {
  Random random(11);
  std::vector<double> values(10007);
  for (double& value : values) value = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-8, 8));
  CudaExecutor cuda;
  CpuExecutor cpu(2);
  CHECK(sum(cuda, values) == sum(cpu, values));
}

TEST_CASE("exchange on CUDA hands each value on exactly once") {
  const int n = 5000;
  CudaExecutor exec;
  DeviceBuffer<int> head, next;
  head.resize(1);
  next.resize(n);
  exec.fill("clear", head.span(), -1);
  exec.parallel_for("link", n, LinkAll{head.span(), next.span()});
  const std::vector<int> links = exec.download(next.span());
  int length = 0;
  for (int i = exec.download(head.span())[0]; i != -1; i = links[i]) ++length;
  CHECK(length == n);
}

TEST_CASE("CUDA launches are timed under their names") {
  CudaExecutor exec;
  DeviceBuffer<int> buffer;
  buffer.resize(100);
  for (int k = 0; k < 600; ++k) exec.fill("clear", buffer.span(), k);  // more than one batch of events
  REQUIRE(exec.stage_times().stages().size() == 1);
  CHECK(exec.stage_times().stages()[0].name == "clear");
  CHECK(exec.stage_times().stages()[0].launches == 600);
}

TEST_CASE("a failing CUDA call names the expression") {
  DeviceBuffer<char> buffer;
  CHECK_THROWS_WITH(buffer.resize(int64_t{1} << 60), Catch::Contains("cudaMalloc"));
  CudaExecutor exec;  // and the failure does not stick
  buffer.resize(10);
  exec.fill("clear", buffer.span(), 'a');
  CHECK(exec.download(buffer.span())[9] == 'a');
}
