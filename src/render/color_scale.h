// SPDX-License-Identifier: MIT
// Places quantities on the scale of sixteen colours. The scale ends at the 98th percentile, so that a few extreme values
// do not leave all others in one colour; they take the last colour, and the legend says "≥".
#pragma once

#include <string>
#include <vector>

#include "render/body_buffer.h"

namespace ballpit {

/// A box of the legend with whole numbers: "0", "1–4", "≥ 5".
struct LegendBox {
  Mark mark;
  std::string text;
};

/// The marks of all bodies, and the legend: boxes for whole numbers, or the values at the ends of the scale. All empty if
/// there is no scale.
struct Colored {
  std::vector<Mark> marks;
  std::string low{}, high{};
  std::vector<LegendBox> boxes{};
  std::string lacking{};  ///< why the method has no such quantity

  bool has_scale() const { return !low.empty() || !boxes.empty(); }
};

/// A continuous quantity: sixteen equal steps. `unit` with a blank before it.
Colored on_scale(const std::vector<float>& values, const char* unit, bool starts_at_zero);

/// Counts from `first` on: a colour for each number, or for each of at most five equal ranges if there are more than ten.
Colored on_whole_numbers(const std::vector<int>& values, int first);

}  // namespace ballpit
