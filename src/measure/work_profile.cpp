// SPDX-License-Identifier: MIT
#include "measure/work_profile.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace ballpit {

namespace {

/// 0, 1, 2 to 3, 4 to 7, …: bin k counts the numbers with k binary digits.
std::vector<WorkBin> count_in_bins(const std::vector<int>& work, int64_t most) {
  std::vector<WorkBin> bins{{0, 0, 0}};
  for (int64_t low = 1; low <= most; low *= 2) bins.push_back({low, 2 * low - 1, 0});
  for (const int steps : work) ++bins[std::bit_width(static_cast<unsigned>(steps))].threads;
  return bins;
}

/// Σ over warps of the longest thread in each.
int64_t warp_time(const std::vector<int>& work) {
  int64_t time = 0;
  for (size_t begin = 0; begin < work.size(); begin += kWarpSize) {
    const size_t end = std::min(begin + kWarpSize, work.size());
    time += *std::max_element(work.begin() + begin, work.begin() + end);
  }
  return time;
}

}  // namespace

WorkProfile profile_work(const std::vector<int>& work) {
  WorkProfile profile;
  profile.threads = static_cast<int64_t>(work.size());
  profile.most = work.empty() ? 0 : *std::max_element(work.begin(), work.end());
  profile.bins = count_in_bins(work, profile.most);
  const auto sum = static_cast<double>(std::accumulate(work.begin(), work.end(), int64_t{0}));
  if (!work.empty()) profile.mean = sum / static_cast<double>(work.size());
  const int64_t time = warp_time(work);
  if (time > 0) profile.simd_efficiency = sum / (kWarpSize * static_cast<double>(time));
  return profile;
}

}  // namespace ballpit
