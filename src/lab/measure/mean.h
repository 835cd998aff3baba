// SPDX-License-Identifier: MIT
// A mean with what is known of its error.
#pragma once

#include <cmath>
#include <numeric>
#include <vector>

namespace ballpit {

struct Mean {
  double value = 0;
  double error = 0;  ///< standard error of the mean
};

/// Of at least two independent values.
inline Mean mean_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squared = 0;
  for (const double value : values) squared += (value - mean) * (value - mean);
  return {mean, std::sqrt(squared / (n * (n - 1)))};
}

}  // namespace ballpit
