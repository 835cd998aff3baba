// SPDX-License-Identifier: MIT
#include "core/heap.h"

#include <cstdint>
#include <cstdlib>
#include <limits>

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace ballpit {

void set_up_heap() {
  constexpr std::uintptr_t kHugePage = 2 << 20;
  constexpr int kGrowth = 64 << 20, kReserve = 1 << 30;  // [bytes]
  const auto end_of_heap = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
  rlimit space{};
  const bool is_limited = getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur != RLIM_INFINITY;
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, is_limited ? kGrowth : kReserve);
  const std::uintptr_t begin = (end_of_heap() + kHugePage - 1) / kHugePage * kHugePage;
  void* volatile block = std::malloc(kHugePage);  // makes the heap grow; volatile, or the compiler removes both calls
  std::free(block);
  const std::uintptr_t end = end_of_heap();
  // A system without huge pages refuses, and a malloc without this heap has not made it grow; then pages are small.
  if (begin < end) static_cast<void>(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE));
  mallopt(M_TOP_PAD, kGrowth);
}

}  // namespace ballpit
