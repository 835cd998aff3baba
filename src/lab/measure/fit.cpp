// SPDX-License-Identifier: MIT
#include "lab/measure/fit.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace ballpit {

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

}  // namespace ballpit
