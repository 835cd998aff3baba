// SPDX-License-Identifier: MIT
// The kernel that runs phases (exec/phases.h). All of its blocks run at once, so that a barrier can order them: a cooperative
// launch. Where there are more indices than threads, each thread takes several.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>

#include <cooperative_groups.h>

#include "cuda_error.h"
#include "exec/phases.h"

namespace ballpit {

inline constexpr int kCudaBlock = 256;  // threads

/// Runs all phases; none if halted.
template <Phases P>
__global__ void run_phases_kernel(const int* halted, P phases) {
  if (halted != nullptr && *halted != 0) return;
  const cooperative_groups::grid_group grid = cooperative_groups::this_grid();
  while (phases.next()) {
    const int64_t size = phases.size();
    for (auto k = int64_t(grid.thread_rank()); k < size; k += int64_t(grid.num_threads())) phases(static_cast<int>(k));
    grid.sync();
  }
}

/// How many blocks of a kernel can run at once.
class ResidentBlocks {
 public:
  template <class Kernel>
  int operator()(Kernel* kernel) {
    const auto key = reinterpret_cast<const void*>(kernel);
    const auto known = blocks_.find(key);
    if (known != blocks_.end()) return known->second;
    int device = 0, multiprocessors = 0, blocks = 0;
    BALLPIT_CUDA_CHECK(cudaGetDevice(&device));
    BALLPIT_CUDA_CHECK(cudaDeviceGetAttribute(&multiprocessors, cudaDevAttrMultiProcessorCount, device));
    BALLPIT_CUDA_CHECK(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks, key, kCudaBlock, 0));
    return blocks_[key] = std::max(1, blocks * multiprocessors);
  }

 private:
  std::map<const void*, int> blocks_;
};

}  // namespace ballpit
