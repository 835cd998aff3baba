// SPDX-License-Identifier: MIT
#include "exec/host_buffer.h"

#include <array>
#include <cstring>

#include <catch2/catch.hpp>

using namespace ballpit;

TEST_CASE("a buffer grows and spans what was asked for") {
  HostBuffer<int> buffer;
  CHECK(buffer.span().empty());
  buffer.resize(10);
  buffer.span()[9] = 4;
  CHECK(buffer.span()[9] == 4);
  buffer.resize(5);
  CHECK(buffer.size() == 5);
  CHECK(buffer.span().size() == 5);
}

TEST_CASE("a buffer that shrinks and grows again keeps its memory") {
  HostBuffer<int> buffer;
  buffer.resize(100);
  const int* const data = buffer.span().data();
  buffer.resize(0);
  buffer.resize(100);
  CHECK(buffer.span().data() == data);
  CHECK(buffer.bytes() == 400);
}

TEST_CASE("a buffer that creeps up allocates seldom") {
  HostBuffer<int> buffer;
  int allocations = 0;
  int64_t held = 0;
  for (int n = 1; n <= 10000; ++n) {
    buffer.resize(n);
    allocations += buffer.bytes() != held;
    held = buffer.bytes();
    REQUIRE(held >= n * 4);
  }
  CHECK(allocations < 30);
  CHECK(held < 10000 * 4 * 2);
}

TEST_CASE("a vector register can be written at any value of a buffer") {  // asan sees what does not belong to it
  struct Three {
    float x, y, z;
  };
  HostBuffer<Three> buffer;
  const std::array<float, 4> lanes = {1, 2, 3, 4};
  static_assert(sizeof lanes == HostBuffer<Three>::kReach);
  for (int n = 1; n <= 200; ++n) {
    buffer.resize(n);
    const Span<Three> values = buffer.span();
    char* const memory = reinterpret_cast<char*>(values.data());
    for (int k = 0; k < n; ++k)
      std::memcpy(memory + sizeof(Three) * static_cast<size_t>(k), lanes.data(), sizeof lanes);
    for (const Three& value : values) REQUIRE((value.x == 1 && value.y == 2 && value.z == 3));
  }
}
