// SPDX-License-Identifier: MIT
// A chart as a value, and the gnuplot script that draws it on a light or a dark background.
//
//     series   lines with markers and error bars, each with its label at its end
//     map      cells coloured by value or category, below the series
//     theory   grey and dotted;  failed runs: × at the edge
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "measure/statistics.h"

namespace ballpit {

enum class Scale { linear, log };
enum class Ground { light, dark };

struct Axis {
  std::string label;      ///< "spheres"
  std::string unit = "";  ///< "ms"; empty: none
  Scale scale = Scale::linear;
  std::optional<double> low = {}, high = {};  ///< the range shown; empty: that of the data
};

/// "time [ms]"
inline std::string title_of(const Axis& axis) {
  return axis.unit.empty() ? axis.label : axis.label + " [" + axis.unit + ']';
}

inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A point. `low` and `high` are the ends of its error bar in y, `left` and `right` in x; kNoNumber: it has none.
struct Point {
  double x;
  double y;  ///< infinite for a failed run
  double low = kNoNumber, high = kNoNumber;
  double left = kNoNumber, right = kNoNumber;
};

/// The median with its quartiles, converted by `factor`: 1e3 gives milliseconds.
inline Point point_of(double x, const Spread& spread, double factor = 1) {
  return {x, factor * spread.median, factor * spread.lower, factor * spread.upper};
}

/// The mean with one standard error.
inline Point point_of(double x, const Mean& mean) {
  return {x, mean.value, mean.value - mean.error, mean.value + mean.error};
}

enum class Stroke { line, points, line_and_points };

/// Points that belong together. The role gives colour, marker and dashes; the label stands at the line's end.
struct Series {
  std::string label;  ///< empty: none is drawn
  std::string role;   ///< a method's name, "theory", "front", "failed", or one of "first" to "seventh"
  std::vector<Point> points = {};
  Stroke stroke = Stroke::line_and_points;
  bool is_dashed = false;  ///< the second of two kinds
  bool is_thin = false;    ///< less important than the others
};

/// A series with a point for each item.
template <class Items, class ToPoint>
Series make_series(const std::string& label, const std::string& role, Stroke stroke, const Items& items,
                   const ToPoint& to_point) {
  Series series{label, role, {}, stroke};
  for (const auto& item : items) series.points.push_back(to_point(item));
  return series;
}

/// The line y(x) of a formula.
template <class Formula>
Series theory_line(const std::string& label, const std::vector<double>& xs, const Formula& y) {
  const auto to_point = [&](double x) { return Point{x, y(x)}; };
  return make_series(label, "theory", Stroke::line, xs, to_point);
}

/// One kind of cell in a map of categories.
struct Category {
  std::string label;
  std::string role;
};

/// A grid of cells: values[row][column], one row for each y. With categories, values are their indices. kNoNumber: not
/// measured.
struct Map {
  std::vector<double> x, y;  ///< centres of the cells, ascending
  std::vector<std::vector<double>> values;
  std::vector<Category> categories = {};
  Axis colors = {""};  ///< of the values; without categories
};

/// A vertical line across the whole chart, with a label at its upper end.
struct Bound {
  double x;
  std::string label;
};

struct Chart {
  std::string name;  ///< the file's stem: "time"
  std::string title;
  Axis x, y;
  std::vector<Series> series = {};
  std::optional<Map> map = {};  ///< drawn below the series
  std::vector<Bound> bounds = {};
  /// Series of points have their labels in a list beside the plot, the first at the top: for points without an order,
  /// whose last one is anywhere.
  bool lists_points = false;
};

/// The script with all its data; it makes gnuplot write an SVG to standard output. Equal charts give equal bytes.
std::string gnuplot_script(const Chart& chart, Ground ground);

// The range of an axis, and its ticks: chart_axis.cpp.

struct Tick {
  double at;
  std::string text;
};

struct AxisRange {
  double low, high;
  Scale scale;

  /// 0 for `low`, 1 for `high`.
  double share_of(double value) const;

  bool shows(double value) const { return value >= low && value <= high; }
};

/// The range that the axis asks for; else that of all values, with a margin if `is_wide`.
AxisRange range_of(const Axis& axis, const std::vector<double>& values, bool is_wide);

/// The number with this share of the way from `low` to `high`, on a linear or a logarithmic scale.
double between(double low, double high, double share, Scale scale);

/// `count` such numbers from `low` to `high`, both included.
std::vector<double> spaced(double low, double high, int count, Scale scale);

/// About eight round numbers at most.
std::vector<Tick> ticks_of(const AxisRange& range);

}  // namespace ballpit
