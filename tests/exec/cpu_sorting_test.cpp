// SPDX-License-Identifier: MIT
// sort_pairs() and bin() of the executor on the CPU: sorted, stable, and the same for any number of threads.
#include <numeric>

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"
#include "tests/exec/arrays.h"

using namespace ballpit;

namespace {

std::vector<int> count_up(int64_t n) {
  std::vector<int> values(static_cast<size_t>(n));
  std::iota(values.begin(), values.end(), 0);
  return values;
}

/// What std::stable_sort makes of 0 … n−1 by their keys.
template <class Key>
std::vector<int> stably_sorted(const std::vector<Key>& keys) {
  std::vector<int> order = count_up(static_cast<int64_t>(keys.size()));
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] < keys[b]; });
  return order;
}

template <class Key>
std::vector<Key> masked(std::vector<Key> keys, int bits) {
  for (Key& key : keys) key &= bits == 0 ? Key(0) : Key(~Key(0)) >> (8 * sizeof(Key) - static_cast<size_t>(bits));
  return keys;
}

template <class Key>
void check_sorting(int64_t n, uint64_t limit, int threads, int bits) {
  INFO("n " << n << ", keys below " << limit << ", threads " << threads << ", bits " << bits);
  const std::vector<Key> original = random_values<Key>(n, limit, 5);
  std::vector<Key> keys = original;
  std::vector<int> values = count_up(n);
  CpuExecutor exec(threads);
  exec.sort_pairs("sort", span_of(keys), span_of(values), bits);
  REQUIRE(values == stably_sorted(masked(original, bits)));
  for (size_t k = 0; k < keys.size(); ++k) REQUIRE(keys[k] == original[static_cast<size_t>(values[k])]);
}

}  // namespace

TEST_CASE("pairs are sorted by key, and stay in order where keys are equal", "[slow]") {
  const int threads = GENERATE(1, 2, 8);
  // Around the block borders of the counting sort: 2¹⁵ indices a block, as many blocks as threads at most.
  for (const int64_t n : {0,     1,     2,     3,     511,   512,   513,   2047,   2048,   2049,
                          32767, 32768, 32769, 65535, 65536, 65537, 98304, 262143, 262144, 262145}) {
    check_sorting<uint32_t>(n, 50, threads, 32);
    check_sorting<uint32_t>(n, uint64_t{1} << 32, threads, 32);
  }
}

TEST_CASE("keys of 8, 16 and 64 bits are sorted by all of them") {
  const int threads = GENERATE(1, 8);
  for (const int64_t n : {100, 70000}) {
    check_sorting<uint8_t>(n, 256, threads, 8);
    check_sorting<uint16_t>(n, 65536, threads, 16);
    check_sorting<uint64_t>(n, UINT64_MAX, threads, 64);
  }
}

TEST_CASE("a limit on bits sorts by the lowest bits alone, and leaves keys whole") {
  const int threads = GENERATE(1, 2);
  for (const int bits : {0, 1, 5, 10, 11, 12, 21, 22, 23, 31, 32}) {
    check_sorting<uint32_t>(5000, uint64_t{1} << 32, threads, bits);
    check_sorting<uint32_t>(70000, uint64_t{1} << 32, threads, bits);
  }
}

TEST_CASE("the values of pairs may be of any plain type") {
  struct Wide {
    double a;
    int b;
  };
  std::vector<uint32_t> keys{3, 1, 2};
  std::vector<Wide> values{{0.3, 3}, {0.1, 1}, {0.2, 2}};
  CpuExecutor exec(1);
  exec.sort_pairs("sort", span_of(keys), span_of(values));
  CHECK(keys == std::vector<uint32_t>{1, 2, 3});
  for (int k = 0; k < 3; ++k) CHECK(values[static_cast<size_t>(k)].b == k + 1);
}

namespace {

/// Bins indices by their keys into `bins` bins, and compares with the definition.
void check_binning_of(const std::vector<int>& keys, int bins, int threads) {
  std::vector<int> offsets(static_cast<size_t>(bins) + 1, -1), order(keys.size(), -1);
  std::vector<int> expected(offsets.size(), 0);
  for (const int key : keys) ++expected[static_cast<size_t>(key) + 1];
  std::partial_sum(expected.begin(), expected.end(), expected.begin());

  CpuExecutor exec(threads);
  exec.bin(
      "bin", [&](int i) { return keys[static_cast<size_t>(i)]; }, span_of(offsets), span_of(order));
  REQUIRE(order == stably_sorted(keys));
  REQUIRE(offsets == expected);
}

/// The same with n random keys below `used`.
void check_binning(int64_t n, int bins, int used, int threads) {
  INFO("n " << n << ", bins " << bins << " of which " << used << " are used, threads " << threads);
  check_binning_of(random_values<int>(n, static_cast<uint64_t>(used), 7), bins, threads);
}

}  // namespace

TEST_CASE("bin puts indices into bins, in their order, and notes where each bin begins", "[slow]") {
  const int threads = GENERATE(1, 2, 8);
  for (const int64_t n : {0, 1, 511, 513, 32768, 65535, 65536, 65537, 300000}) {
    check_binning(n, 1, 1, threads);  // one bin
    check_binning(n, 100, 100, threads);
    check_binning(n, 100, 3, threads);  // empty bins at the end
    check_binning(n, 5000, 5000, threads);
    check_binning(n, 600000, 600000, threads);  // more bins than indices: most are empty, and blocks are few
  }
}

TEST_CASE("keys that are nearly sorted, of few bins or all equal are binned the same by any number of threads") {
  const int threads = GENERATE(1, 2, 8);
  const int n = GENERATE(5000, 100000), bins = GENERATE(5000, 100000, 400000);
  INFO("n " << n << ", bins " << bins << ", threads " << threads);
  const std::vector<int> jitter = random_values<int>(n, 50, 5);
  std::vector<int> rising, last_few;
  for (int i = 0; i < n; ++i) {
    rising.push_back(std::min(static_cast<int>(int64_t(i) * bins / n) + jitter[static_cast<size_t>(i)], bins - 1));
    last_few.push_back(bins - 1 - jitter[static_cast<size_t>(i)]);
  }
  check_binning_of(rising, bins, threads);
  check_binning_of({rising.rbegin(), rising.rend()}, bins, threads);
  check_binning_of(last_few, bins, threads);
  check_binning_of(std::vector<int>(static_cast<size_t>(n), 0), bins, threads);
  check_binning_of(std::vector<int>(static_cast<size_t>(n), bins - 1), bins, threads);
}

TEST_CASE("nothing in no bins leaves one offset, zero") {
  CpuExecutor exec(2);
  std::vector<int> offsets{-1}, order;
  exec.bin(
      "bin", [](int) { return 0; }, span_of(offsets), span_of(order));
  CHECK(offsets == std::vector<int>{0});
}

TEST_CASE("a bin before and after empty ones begins and ends where its indices do") {
  CpuExecutor exec(1);
  std::vector<int> offsets(6), order(3);
  exec.bin(
      "bin", [](int) { return 2; }, span_of(offsets), span_of(order));
  CHECK(offsets == std::vector<int>{0, 0, 0, 3, 3, 3});
  CHECK(order == std::vector<int>{0, 1, 2});
}

TEST_CASE("bin sorts values of indices as it sorts the indices") {
  const int threads = GENERATE(1, 2, 8);
  const int64_t n = GENERATE(10, 100000);
  struct Wide {
    double a;
    int b;
  };
  const std::vector<int> keys = random_values<int>(n, 77, 3);
  std::vector<int> offsets(78), order(static_cast<size_t>(n)), offsets_again(78);
  std::vector<Wide> values(static_cast<size_t>(n));
  CpuExecutor exec(threads);
  const auto key_of = [&](int i) { return keys[static_cast<size_t>(i)]; };
  exec.bin("bin", key_of, span_of(offsets), span_of(order));
  exec.bin(
      "bin", key_of,
      [](int i) {
        return Wide{0.5 * i, -i};
      },
      span_of(offsets_again), span_of(values));
  CHECK(offsets == offsets_again);
  for (size_t k = 0; k < order.size(); ++k) {
    REQUIRE(values[k].a == 0.5 * order[k]);
    REQUIRE(values[k].b == -order[k]);
  }
}

TEST_CASE("a key is asked for once, so that it may be costly") {
  CpuExecutor exec(1);
  int asked = 0;
  std::vector<int> offsets(11), order(1000);
  exec.bin(
      "bin",
      [&](int i) {
        ++asked;
        return i % 10;
      },
      span_of(offsets), span_of(order));
  CHECK(asked == 1000);
}
