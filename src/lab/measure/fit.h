// SPDX-License-Identifier: MIT
// Straight lines through measured points.
#pragma once

#include <vector>

namespace ballpit {

struct PowerFit {
  double exponent = 0;
  double error = 0;   ///< standard error of the exponent; 0 for two points
  double factor = 0;  ///< y = factor · x^exponent
};

/// Least squares in log y over log x, all points alike. At least two points, all values above 0.
PowerFit fit_power(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace ballpit
