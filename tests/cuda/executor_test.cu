// SPDX-License-Identifier: MIT
// The CUDA executor keeps the contract of the CPU executor.
#include <algorithm>
#include <cmath>
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
  __device__ void operator()(int i) const { atomicAdd(&calls[i], 1); }
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

template <class Key, class Value>
struct Sorted {
  std::vector<Key> keys;
  std::vector<Value> values;
  friend bool operator==(const Sorted&, const Sorted&) = default;
};

/// The keys sorted by their lowest bits, with where each came from.
template <class Value, class Exec, class Key>
Sorted<Key, Value> sort(Exec& exec, const std::vector<Key>& keys, int bits) {
  std::vector<Value> values(keys.size());
  std::iota(values.begin(), values.end(), Value(0));
  typename Exec::template Buffer<Key> key_buffer;
  typename Exec::template Buffer<Value> value_buffer;
  exec.upload(key_buffer, keys);
  exec.upload(value_buffer, values);
  exec.sort_pairs("sort", key_buffer.span(), value_buffer.span(), bits);
  return {exec.download(key_buffer.span()), exec.download(value_buffer.span())};
}

struct KeyAt {
  Span<const int> keys;
  HOST_DEVICE int operator()(int i) const { return keys[i]; }
};

/// A value that is neither its index nor of an integer's size.
struct Tagged {
  int index;
  double weight;
  int tag;
  friend bool operator==(const Tagged&, const Tagged&) = default;
};

struct TagAt {
  HOST_DEVICE Tagged operator()(int i) const { return {i, 0.5 * i, -i}; }
};

struct Binned {
  std::vector<int> offsets, order, offsets_of_values;
  std::vector<Tagged> values;
  friend bool operator==(const Binned&, const Binned&) = default;
};

/// Indices and values by key, both ways.
template <class Exec>
Binned bin(Exec& exec, const std::vector<int>& keys, int bins) {
  const auto n = static_cast<int64_t>(keys.size());
  typename Exec::template Buffer<int> key_buffer, offsets, order;
  typename Exec::template Buffer<Tagged> values;
  exec.upload(key_buffer, keys);
  offsets.resize(bins + 1);
  order.resize(n);
  values.resize(n);
  const KeyAt key_of{key_buffer.span()};
  Binned result;
  exec.bin("bin", key_of, offsets.span(), order.span());
  result.offsets = exec.download(offsets.span());
  result.order = exec.download(order.span());
  exec.fill("clear", offsets.span(), -7);
  exec.bin("bin", key_of, TagAt{}, offsets.span(), values.span());
  result.offsets_of_values = exec.download(offsets.span());
  result.values = exec.download(values.span());
  return result;
}

/// The same by definition.
Binned bin_by_definition(const std::vector<int>& keys, int bins) {
  Binned result;
  for (int bin = 0; bin < bins; ++bin) {
    result.offsets.push_back(static_cast<int>(result.order.size()));
    for (size_t i = 0; i < keys.size(); ++i) {
      if (keys[i] == bin) result.order.push_back(static_cast<int>(i));
    }
  }
  result.offsets.push_back(static_cast<int>(keys.size()));
  result.offsets_of_values = result.offsets;
  for (const int i : result.order) result.values.push_back(TagAt{}(i));
  return result;
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

TEST_CASE("exclusive scan on CUDA gives each element the sum of those before it", "[sanitized]") {
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
  const int64_t total = exec.exclusive_scan("scan", in.span(), out.span());
  CHECK(total == 6000000000);
}

TEST_CASE("sorting pairs on CUDA is stable and goes by the lowest bits of the keys, as on the CPU", "[sanitized]") {
  const int n = GENERATE(0, 1, 2, 300, 9000);  // by one block of threads, and by many
  const int bits = GENERATE(0, 1, 8, 13, 24, 32);
  Random random(5);
  std::vector<uint32_t> keys(static_cast<size_t>(n));
  for (uint32_t& key : keys) key = static_cast<uint32_t>(random.uniform() * 4294967295.0) & 0xFF000F1Fu;
  CAPTURE(n, bits);
  CudaExecutor cuda;
  CpuExecutor cpu(2);
  CHECK(sort<int>(cuda, keys, bits) == sort<int>(cpu, keys, bits));
}

TEST_CASE("keys and values of other sizes are sorted on CUDA") {
  Random random(6);
  std::vector<uint64_t> wide(700);
  std::vector<uint8_t> narrow(700);
  for (uint64_t& key : wide) key = static_cast<uint64_t>(random.uniform() * 1e19);
  for (uint8_t& key : narrow) key = static_cast<uint8_t>(random.uniform() * 256);
  CudaExecutor cuda;
  CpuExecutor cpu(2);
  CHECK(sort<double>(cuda, wide, 64) == sort<double>(cpu, wide, 64));
  CHECK(sort<int64_t>(cuda, narrow, 8) == sort<int64_t>(cpu, narrow, 8));
}

TEST_CASE("binning on CUDA gives what it gives on the CPU, which is right", "[sanitized]") {
  const int n = GENERATE(0, 1, 2, 300, 9000);
  const int bins = GENERATE(1, 2, 7, 8, 300, 5000);
  CAPTURE(n, bins);
  CudaExecutor cuda;
  CpuExecutor cpu(2);
  const std::vector<int> keys = random_ints(n, bins, 7);
  const Binned expected = bin(cpu, keys, bins);
  CHECK(bin(cuda, keys, bins) == expected);
  if (n <= 300) CHECK(expected == bin_by_definition(keys, bins));
}

TEST_CASE("bins on CUDA may all be empty but one, anywhere") {
  const int bins = 3001;
  const int full = GENERATE(0, 1, 7, 8, 1500, 2999, 3000);
  CAPTURE(full);
  CudaExecutor cuda;
  const std::vector<int> keys(200, full);
  CHECK(bin(cuda, keys, bins) == bin_by_definition(keys, bins));
}

TEST_CASE("an executor on CUDA bins much, then little, then much again") {
  CudaExecutor cuda;
  for (const int n : {6000, 10, 6000, 0, 3}) {
    for (const int bins : {4000, 3, 1}) {
      CAPTURE(n, bins);
      CpuExecutor cpu(1);
      const std::vector<int> keys = random_ints(n, bins, 8);
      CHECK(bin(cuda, keys, bins) == bin(cpu, keys, bins));
    }
  }
}

TEST_CASE("both scratch memories on CUDA last beside each other, and beside sorting") {
  CudaExecutor exec;
  const Span<double> a = exec.scratch<double>(0, 100);
  const Span<int> b = exec.scratch<int>(1, 100);
  exec.fill("fill", a, 0.25);
  exec.fill("fill", b, 7);
  bin(exec, random_ints(500, 60, 9), 60);
  CHECK(exec.download(a) == std::vector<double>(100, 0.25));
  CHECK(exec.download(b) == std::vector<int>(100, 7));
}

TEST_CASE("a floating-point sum has the same bits on CUDA and CPU", "[sanitized]") {
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

TEST_CASE("CUDA launches are timed under their names, if somebody asks") {
  CudaExecutor exec;
  DeviceBuffer<int> buffer;
  buffer.resize(100);
  exec.fill("clear", buffer.span(), 1);
  CHECK(exec.stage_times().stages().empty());
  exec.time_stages(true);
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
