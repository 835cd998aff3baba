// SPDX-License-Identifier: MIT
// How evenly the work of a search lies on its threads, and what a GPU makes of that: the threads of a warp walk in
// lockstep, so a warp takes as long as its longest thread.
//
//     work        3 1 2 2 | 9 1 0 1      warps of four, here
//     longest     3       | 9            busy: 8 of 12  | 11 of 36, together 19 of 48
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace ballpit {

inline constexpr int kWarpSize = 32;  ///< threads in lockstep on NVIDIA GPUs

/// So many threads with work in low … high.
struct WorkBin {
  int64_t low;
  int64_t high;
  int64_t threads;
};

struct WorkProfile {
  int64_t threads = 0;
  int64_t most = 0;  ///< of one thread
  double mean = 0;
  std::vector<WorkBin> bins;  ///< 0, 1, 2 to 3, 4 to 7, … up to the one that holds `most`
  /// Work over what warps have time for: Σ work / (kWarpSize · Σ longest of each warp). Nothing where there is no work.
  std::optional<double> simd_efficiency;
};

/// Of the work of each thread, in the order of the threads.
WorkProfile profile_work(const std::vector<int>& work);

}  // namespace ballpit
