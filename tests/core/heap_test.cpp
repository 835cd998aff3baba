// SPDX-License-Identifier: MIT
#include "core/heap.h"

#include <cstdint>
#include <cstdlib>

#include <catch2/catch.hpp>
#include <unistd.h>

using namespace ballpit;

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which have heaps of their own

TEST_CASE("large blocks lie in the heap, and freed memory stays there") {
  set_up_heap();
  const auto end_of_heap = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
  const std::uintptr_t end = end_of_heap();
  constexpr std::uintptr_t kSize = 32 << 20;
  void* volatile block = std::malloc(kSize);
  const auto begin = reinterpret_cast<std::uintptr_t>(block);
  REQUIRE((begin < end && begin + kSize <= end));
  std::free(block);
  REQUIRE(end_of_heap() == end);
}

#endif
