// SPDX-License-Identifier: MIT
#include "core/heap.h"

#include <cstdint>
#include <cstdlib>

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

namespace ballpit {

void set_up_heap() {
  constexpr std::uintptr_t kHugePage = 2 << 20, kSize = 64 << 20;
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, kSize);
  void* volatile block = std::malloc(kHugePage);  // makes the heap grow; volatile, or the compiler removes both calls
  std::free(block);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  const std::uintptr_t begin = (end - kSize + kHugePage - 1) / kHugePage * kHugePage;
  // A system without huge pages, or a malloc without this heap, refuses; then pages are small, as they were.
  static_cast<void>(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE));
}

}  // namespace ballpit
