// SPDX-License-Identifier: MIT
// An axis with its range settled and its ticks chosen.
#pragma once

#include <string>
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

  /// Where a value stands, from 0 at `low` to 1 at `high`.
  double share_of(double value) const;

  bool shows(double value) const { return value >= low && value <= high; }
};

/// What the axis asks for, else what holds all values, with a margin where `is_wide`.
Range range_of(const Axis& axis, const std::vector<double>& values, bool is_wide);

/// Round numbers: at most about eight.
std::vector<Tick> ticks_of(const Range& range);

/// "0.01", "1 000", "10⁵": short, for people.
std::string tick_text(double value);

/// "time a step [ms]"
std::string title_of(const Axis& axis);

}  // namespace ballpit
