// SPDX-License-Identifier: MIT
// A gnuplot script under construction: the drawing commands that all parts of a chart share.
#pragma once

#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "lab/charts/chart.h"
#include "lab/charts/chart_style.h"

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

/// The text with `with` in all places of `what`.
std::string replaced(std::string text, std::string_view what, std::string_view with);

/// One line of a data block.
std::string data_line(std::initializer_list<double> numbers);

/// Text in gnuplot's single quotes.
std::string quoted_text(std::string_view text);

/// "rgb '#0072B2'"
std::string rgb(Rgb color);

class ChartScript {
 public:
  ChartScript(Ground ground, const std::pair<AxisRange, AxisRange>& ranges)
      : ground_(ground), style_(ground_style(ground)), x_(ranges.first), y_(ranges.second) {}

  Ground ground() const { return ground_; }
  const GroundStyle& style() const { return style_; }
  const AxisRange& x() const { return x_; }
  const AxisRange& y() const { return y_; }

  /// Where a point of the plot is in the picture.
  double place_x(double x) const { return kPlotLeft + x_.share_of(x) * (kPlotRight - kPlotLeft); }
  double place_y(double y) const { return kPlotBottom + y_.share_of(y) * (kPlotTop - kPlotBottom); }

  template <class... Parts>
  void line(fmt::format_string<Parts...> format, Parts&&... parts) {
    text_ += fmt::format(format, std::forward<Parts>(parts)...) + '\n';
  }

  /// Plots the lines of a data block; `format` and `parts` are what follows its name.
  template <class... Parts>
  void plot(const std::string& data, fmt::format_string<Parts...> format, Parts&&... parts) {
    plots_ += (plots_.empty() ? "" : ", \\\n     ") + data + fmt::format(format, std::forward<Parts>(parts)...);
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
  AxisRange x_, y_;
  std::string text_, data_, plots_;
  int blocks_ = 0;
};

}  // namespace ballpit
