// SPDX-License-Identifier: MIT
// How evenly a search distributes its work over threads, and how busy that keeps a GPU: the threads of a warp run in
// lockstep, so a warp takes as long as its longest thread.
//
//     work        3 1 2 2 | 9 1 0 1      in warps of four threads
//     longest     3       | 9            busy: 8 of 12  | 11 of 36, together 19 of 48
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace ballpit {

inline constexpr int kWarpSize = 32;  ///< threads in lockstep on NVIDIA GPUs

/// The number of threads with low to high units of work.
struct WorkBin {
  int64_t low;
  int64_t high;
  int64_t threads;
};

struct WorkProfile {
  int64_t threads = 0;
  int64_t most = 0;  ///< work of one thread
  double mean = 0;
  std::vector<WorkBin> bins;  ///< 0, 1, 2 to 3, 4 to 7, … up to the one that holds `most`
  /// Σ work / (kWarpSize · Σ longest of each warp); empty if there is no work.
  std::optional<double> simd_efficiency;
};

/// `work` is that of each thread, in the order of the threads.
WorkProfile profile_work(const std::vector<int>& work);

}  // namespace ballpit
