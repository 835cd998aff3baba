// SPDX-License-Identifier: MIT
// The range of an axis, and its ticks.
#pragma once

#include <vector>

#include "lab/charts/chart.h"

namespace ballpit {

struct Tick {
  double at;
  std::string text;
};

struct Range {
  double low, high;
  Scale scale;

  /// 0 for `low`, 1 for `high`.
  double share_of(double value) const;

  bool shows(double value) const { return value >= low && value <= high; }
};

/// The range that the axis asks for; else that of all values, with a margin if `is_wide`.
Range range_of(const Axis& axis, const std::vector<double>& values, bool is_wide);

/// The number with this share of the way from `low` to `high`, on a linear or a logarithmic scale.
double between(double low, double high, double share, Scale scale);

/// `count` such numbers from `low` to `high`, both included.
std::vector<double> spaced(double low, double high, int count, Scale scale);

/// About eight round numbers at most.
std::vector<Tick> ticks_of(const Range& range);

/// "0.01", "1 000", "10⁵".
std::string tick_text(double value);

}  // namespace ballpit
