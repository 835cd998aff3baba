// SPDX-License-Identifier: MIT
// What is made of repeated measurements: median and quartiles, which a few slow runs do not change; means; power laws.
#pragma once

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

}  // namespace ballpit
