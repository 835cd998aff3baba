// SPDX-License-Identifier: MIT
// What repeated measurements of one quantity come to: median and quartiles, which a few slow runs do not move.
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

}  // namespace ballpit
