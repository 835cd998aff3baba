// SPDX-License-Identifier: MIT
#include "core/heap.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>
#include <unistd.h>

using namespace ballpit;

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which have heaps of their own

namespace {

/// The flags of the mapping that holds an address (man 5 proc, smaps): "hg" means that it asks for huge pages.
std::string flags_of_mapping(std::uintptr_t address) {
  std::ifstream maps("/proc/self/smaps");
  bool holds = false;
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    if (std::istringstream(line) >> std::hex >> begin >> dash >> end && dash == '-') {
      holds = begin <= address && address < end;
    }
    if (holds && line.starts_with("VmFlags:")) return line + " ";
  }
  return "";
}

}  // namespace

TEST_CASE("large blocks lie in the heap, which asks for huge pages, and freed memory stays there") {
  set_up_heap();
  const auto end_of_heap = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
  const std::uintptr_t end = end_of_heap();
  constexpr std::uintptr_t kSize = 32 << 20;
  void* volatile block = std::malloc(kSize);
  const auto begin = reinterpret_cast<std::uintptr_t>(block);
  REQUIRE((begin < end && begin + kSize <= end));
  if (std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) {
    CHECK(flags_of_mapping(begin + kSize / 2).find(" hg ") != std::string::npos);
  }
  std::free(block);
  REQUIRE(end_of_heap() == end);
}

#endif
