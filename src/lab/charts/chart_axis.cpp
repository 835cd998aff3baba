// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/language.h"
#include "core/numbers.h"
#include "lab/charts/chart.h"

namespace ballpit {

namespace {

/// "10⁻³"
std::string power_text(int exponent) {
  constexpr std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = "10";
  if (exponent < 0) text += "⁻";
  for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[static_cast<size_t>(digit - '0')];
  return text;
}

/// "0.01", "1 000", "10⁵".
std::string tick_text(double value) {
  const double size = std::fabs(value);
  const double exponent = std::round(std::log10(size));
  if (size > 0 && (size < 0.00099 || size > 99999)) {
    const int power = static_cast<int>(std::floor(std::log10(size) + 1e-9));
    const double part = value / std::pow(10.0, power);
    if (std::fabs(part - 1) < 1e-6) return power_text(static_cast<int>(exponent));
    return local_number(fmt::format("{:.3g}", part)) + "·" + power_text(power);
  }
  if (size > 9999) return grouped(static_cast<int64_t>(std::llround(value)));
  return local_number(fmt::format("{:.5g}", size < 1e-12 ? 0.0 : value));
}

std::vector<Tick> log_ticks(const AxisRange& range) {
  const double decades = std::log10(range.high / range.low);
  const int every = decades > 16 ? 4 : decades > 8 ? 2 : 1;
  const std::vector<double> parts = decades < 2.5 ? std::vector<double>{1, 2, 5} : std::vector<double>{1};
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.low)));
  for (int exponent = first; exponent <= std::log10(range.high); ++exponent) {
    if (exponent % every != 0) continue;
    for (const double part : parts) {
      const double at = part * std::pow(10.0, exponent);
      if (at >= range.low * 0.999 && at <= range.high * 1.001) ticks.push_back({at, tick_text(at)});
    }
  }
  return ticks;
}

std::vector<Tick> linear_ticks(const AxisRange& range) {
  const double rough = (range.high - range.low) / 5;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = power * (rough / power < 1.5 ? 1 : rough / power < 3.5 ? 2 : rough / power < 7.5 ? 5 : 10);
  std::vector<Tick> ticks;
  const double slack = 1e-6 * step;
  for (auto k = static_cast<int64_t>(std::ceil((range.low - slack) / step));; ++k) {
    const double at = static_cast<double>(k) * step;
    if (at > range.high + slack) break;
    ticks.push_back({at, tick_text(at)});
  }
  return ticks;
}

}  // namespace

double AxisRange::share_of(double value) const {
  if (scale == Scale::linear) return (value - low) / (high - low);
  return std::log(value / low) / std::log(high / low);
}

AxisRange range_of(const Axis& axis, const std::vector<double>& values, bool is_wide) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value) || (axis.scale == Scale::log && value <= 0)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) low = 1, high = 10;
  const double margin = is_wide ? 0.05 : 0;
  if (axis.scale == Scale::log) {
    const double factor = low == high ? 2 : std::pow(high / low, margin);
    low /= factor;
    high *= factor;
  } else {
    const double width = low == high ? std::max(1.0, std::fabs(low)) : (high - low) * margin;
    low -= width;
    high += width;
  }
  return {axis.low.value_or(low), axis.high.value_or(high), axis.scale};
}

double between(double low, double high, double share, Scale scale) {
  return scale == Scale::log ? std::exp(std::lerp(std::log(low), std::log(high), share)) : std::lerp(low, high, share);
}

std::vector<double> spaced(double low, double high, int count, Scale scale) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(between(low, high, k / (count - 1.0), scale));
  return values;
}

std::vector<Tick> ticks_of(const AxisRange& range) {
  return range.scale == Scale::log ? log_ticks(range) : linear_ticks(range);
}

}  // namespace ballpit
