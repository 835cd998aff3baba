// SPDX-License-Identifier: MIT
// A chart as a value, and the gnuplot script that draws it: one look for all, on light and on dark ground.
//
//     series: lines with markers and spreads, each with its label at its end; or a map: cells coloured by value or category
//     theory: grey, dotted; failed runs: × at the edge
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace ballpit {

enum class Scale { linear, log };
enum class Ground { light, dark };

struct Axis {
  std::string label;      ///< "spheres"
  std::string unit = "";  ///< "ms"; empty: none
  Scale scale = Scale::linear;
  std::optional<double> low = {}, high = {};  ///< the range shown; empty: that of what is drawn
};

inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A point; `low` and `high` are the ends of its spread in y (quartiles, errors), kNoNumber where it has none.
struct Point {
  double x;
  double y;  ///< a failed run stands at infinity
  double low = kNoNumber;
  double high = kNoNumber;
  double left = kNoNumber, right = kNoNumber;  ///< the same in x
};

enum class Stroke { line, points, line_and_points, steps };

/// What belongs together. Its role gives colour, marker and dashes, see roles(); every label is drawn at the line's end.
struct Series {
  std::string label;  ///< empty: none is drawn
  std::string role;   ///< a method's name, "theory", "bound", "failed", or one of "first" to "sixth"
  std::vector<Point> points;
  Stroke stroke = Stroke::line_and_points;
  bool is_dashed = false;  ///< CUDA, or the second of two kinds
  bool is_thin = false;    ///< one of many, beside what matters
};

/// One kind of cell in a map of categories.
struct Category {
  std::string label;
  std::string role;
};

/// A grid of cells: values[row][column], a row for each y. With categories, values are their indices. kNoNumber: nothing
/// was measured there.
struct Map {
  std::vector<double> x, y;  ///< centres of the cells, ascending
  std::vector<std::vector<double>> values;
  std::vector<Category> categories = {};
  std::string label = "";  ///< of the values, with their unit; without categories
  bool is_log = false;     ///< colours go by the values' logarithm
  std::optional<double> low = {},
                        high = {};  ///< the values at both ends of the colours; empty: the least and the largest
};

/// A line across the whole chart at one x, with a word at its upper end.
struct Bound {
  double x;
  std::string label;
};

struct Chart {
  std::string name;  ///< the file's stem: "time"
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  std::optional<Map> map = {};  ///< drawn below the series
  std::vector<Bound> bounds = {};
};

/// The script, all data inside; it writes an SVG to standard output. The same chart gives the same bytes.
std::string gnuplot_script(const Chart& chart, Ground ground);

}  // namespace ballpit
