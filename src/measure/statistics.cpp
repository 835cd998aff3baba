// SPDX-License-Identifier: MIT
#include "measure/statistics.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>

namespace ballpit {

namespace {

double quantile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

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

Spread spread_of(std::vector<double> values) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  return {values.front(), quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

Mean mean_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squared = 0;
  for (const double value : values) squared += (value - mean) * (value - mean);
  return {mean, std::sqrt(squared / (n * (n - 1)))};
}

PowerFit fit_power(const std::vector<double>& x, const std::vector<double>& y) {
  assert(x.size() == y.size() && x.size() >= 2);
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0;
  for (size_t k = 0; k < x.size(); ++k) {
    mean_x += std::log(x[k]) / n;
    mean_y += std::log(y[k]) / n;
  }
  double xx = 0, xy = 0;
  for (size_t k = 0; k < x.size(); ++k) {
    const double dx = std::log(x[k]) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(y[k]) - mean_y);
  }
  PowerFit fit;
  fit.exponent = xy / xx;
  fit.factor = std::exp(mean_y - fit.exponent * mean_x);
  double rest = 0;
  for (size_t k = 0; k < x.size(); ++k) {
    const double residual = std::log(y[k] / fit.factor) - fit.exponent * std::log(x[k]);
    rest += residual * residual;
  }
  if (x.size() > 2) fit.error = std::sqrt(rest / (n - 2) / xx);
  return fit;
}

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
