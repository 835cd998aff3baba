// SPDX-License-Identifier: MIT
#include "render/color_scale.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/language.h"
#include "core/numbers.h"

namespace ballpit {

namespace {

constexpr double kShown = 0.98;  // of the values lie on the scale
constexpr int kMaxNumbers = 10, kMaxRanges = 5;

/// The smallest value that at least 98 % of the values do not exceed. With fewer than 50 values, that is the largest.
template <class Value>
Value upper_end(std::vector<Value> values) {
  const auto rank = static_cast<size_t>(std::ceil(kShown * static_cast<double>(values.size())));
  const auto found = values.begin() + static_cast<std::ptrdiff_t>(std::max<size_t>(rank, 1) - 1);
  std::nth_element(values.begin(), found, values.end());
  return *found;
}

/// With two significant digits: 3, 12, 650. The smallest width with which `numbers` numbers give at most five ranges.
int range_width(int64_t numbers) {
  const int64_t least = (numbers + kMaxRanges - 1) / kMaxRanges;
  int64_t ten = 1;
  while (ten * 100 <= least) ten *= 10;
  return static_cast<int>((least + ten - 1) / ten * ten);
}

}  // namespace

Colored on_scale(const std::vector<float>& values, const char* unit, bool starts_at_zero) {
  Colored result;
  if (values.empty()) return result;
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  const float low = starts_at_zero ? std::min(0.0f, *min) : *min;
  float high = upper_end(values);
  if (high <= low) high = *max;  // nearly all are equal
  const float range = high - low;
  result.marks.reserve(values.size());
  for (const float value : values) {
    const float part = range > 0 ? (value - low) / range : 0.0f;
    const float step = std::clamp(part * kScaleColors, 0.0f, kScaleColors - 1.0f);
    result.marks.push_back(scale_mark(static_cast<int>(step)));
  }
  result.low = local_number(fmt::format("{:.3g}{}", low, unit));
  result.high = local_number(fmt::format("{}{:.3g}{}", *max > high ? "≥ " : "", high, unit));
  return result;
}

Colored on_whole_numbers(const std::vector<int>& values, int first) {
  Colored result;
  if (values.empty()) return result;
  const int max = *std::max_element(values.begin(), values.end());
  const int last = std::max(upper_end(values), first);
  const int64_t numbers = int64_t{last} - first + 1;
  const int width = numbers <= kMaxNumbers ? 1 : range_width(numbers);
  const auto count = static_cast<int>((numbers + width - 1) / width);
  const auto mark_of = [&](int box) { return scale_mark(count > 1 ? box * (kScaleColors - 1) / (count - 1) : 0); };
  for (int box = 0; box < count; ++box) {
    const int64_t low = first + int64_t{box} * width, high = low + width - 1;
    const bool is_open = box == count - 1 && max > high;
    result.boxes.push_back({mark_of(box), is_open      ? "≥ " + grouped(low)
                                          : width == 1 ? grouped(low)
                                                       : fmt::format("{}–{}", grouped(low), grouped(high))});
  }
  result.marks.reserve(values.size());
  for (const int value : values) result.marks.push_back(mark_of(std::clamp((value - first) / width, 0, count - 1)));
  return result;
}

}  // namespace ballpit
