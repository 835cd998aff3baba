// SPDX-License-Identifier: MIT
#include "exec/atomics.h"

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"

using namespace ballpit;

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
