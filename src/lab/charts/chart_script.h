// SPDX-License-Identifier: MIT
// A gnuplot script under construction: the drawing commands that all parts of a chart share.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "lab/charts/chart_axis.h"
#include "lab/charts/chart_style.h"
#include "scene/input_error.h"

namespace ballpit {

// Positions are fractions of the picture, y up. These four lines enclose the plot; labels stand to the right of it.
inline constexpr double kChartWidth = 720, kChartHeight = 520;  ///< [px]
inline constexpr double kPlotLeft = 0.12, kPlotRight = 0.725, kPlotBottom = 0.155, kPlotTop = 0.8;
inline constexpr double kLabelHeight = 0.046;  ///< of a label

/// A text beside the end of a line.
struct Label {
  double x, y;  ///< of its left end
  std::string text;
  Rgb color;
};

/// A double as the shortest text that reads back as the same number; other values unchanged.
template <class Part>
auto exact(const Part& part) {
  if constexpr (std::is_same_v<Part, double>) {
    return number_text(part);
  } else if constexpr (std::is_integral_v<Part>) {
    return part;
  } else {
    return std::string_view(part);
  }
}

template <class... Parts>
std::string script_text(std::string_view format, const Parts&... parts) {
  return fmt::format(fmt::runtime(format), exact(parts)...);
}

/// One line of a data block.
std::string data_line(std::initializer_list<double> numbers);

/// Text in gnuplot's single quotes.
std::string quoted_text(const std::string& text);

/// "rgb '#0072B2'"
std::string rgb(Rgb color);

class ChartScript {
 public:
  ChartScript(Ground ground, const Range& x, const Range& y)
      : ground_(ground), style_(ground_style(ground)), x_(x), y_(y) {}

  Ground ground() const { return ground_; }
  const GroundStyle& style() const { return style_; }
  const Range& x() const { return x_; }
  const Range& y() const { return y_; }

  /// Where a point of the plot is in the picture.
  double place_x(double x) const { return kPlotLeft + x_.share_of(x) * (kPlotRight - kPlotLeft); }
  double place_y(double y) const { return kPlotBottom + y_.share_of(y) * (kPlotTop - kPlotBottom); }

  template <class... Parts>
  void line(std::string_view format, const Parts&... parts) {
    text_ += script_text(format, parts...) + '\n';
  }

  /// Plots the lines of a data block; `format` and `parts` are what follows its name.
  template <class... Parts>
  void plot(const std::string& data, std::string_view format, const Parts&... parts) {
    plots_ += (plots_.empty() ? "" : ", \\\n     ") + data + script_text(format, parts...);
  }

  void write_text(double x, double y, const std::string& text, Rgb color, std::string_view where = "left",
                  double size = 20);

  /// Moves labels apart where they would cover each other, keeps their order from bottom to top, and writes them. Each
  /// has an opaque background, so that lines behind it leave it readable.
  void write_labels(std::vector<Label> labels);

  /// Adds a data block with these lines and returns its name.
  std::string block(const std::string& lines);

  std::string finish() const { return text_ + data_ + "plot " + plots_ + '\n'; }

 private:
  Ground ground_;
  GroundStyle style_;
  Range x_, y_;
  std::string text_, data_, plots_;
  int blocks_ = 0;
};

}  // namespace ballpit
