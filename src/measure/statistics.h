// SPDX-License-Identifier: MIT
// What is made of measurements: median and quartiles, which a few slow runs do not change; means; power laws; and how
// evenly a search distributes its work over threads.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace ballpit {

struct Spread {
  double least = 0;
  double lower = 0;  ///< quartile: a quarter of the values are at most this
  double median = 0;
  double upper = 0;  ///< quartile
};

/// Of at least one value. Between two values, quantiles are interpolated linearly: definition 7 of Hyndman and Fan
/// 1996, doi 10.1080/00031305.1996.10473566.
Spread spread_of(std::vector<double> values);

struct Mean {
  double value = 0;
  double error = 0;  ///< standard error of the mean
};

/// Of at least two independent values.
Mean mean_of(const std::vector<double>& values);

struct PowerFit {
  double exponent = 0;
  double error = 0;   ///< standard error of the exponent; 0 for two points
  double factor = 0;  ///< y = factor · x^exponent
};

/// Least squares of log y over log x with equal weights. At least two points, all values above 0.
PowerFit fit_power(const std::vector<double>& x, const std::vector<double>& y);

// Work per thread. The threads of a GPU run in lockstep, in warps: a warp takes as long as its longest thread.
//
//     work        3 1 2 2 | 9 1 0 1      in warps of four threads
//     longest     3       | 9            busy: 8 of 12  | 11 of 36, together 19 of 48

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
