// SPDX-License-Identifier: MIT
// A gnuplot script in the making: what all parts of a chart draw with.
#pragma once

#include <string>

#include "lab/charts/chart_axis.h"
#include "lab/charts/chart_style.h"

namespace ballpit {

// Of the picture; y up. Between them are the axes; what is right of them belongs to labels.
inline constexpr double kChartWidth = 720, kChartHeight = 520;  ///< [px]
inline constexpr double kLeft = 0.12, kRight = 0.725, kBottom = 0.155, kTop = 0.8;
inline constexpr double kLineHeight = 0.046;  ///< of a label

class ChartScript {
 public:
  ChartScript(Ground ground, const Range& x, const Range& y)
      : ground_(ground), style_(ground_style(ground)), x_(x), y_(y) {}

  Ground ground() const { return ground_; }
  const GroundStyle& style() const { return style_; }
  const Range& x() const { return x_; }
  const Range& y() const { return y_; }

  /// Where a point of the axes is in the picture.
  double place_x(double x) const { return kLeft + x_.share_of(x) * (kRight - kLeft); }
  double place_y(double y) const { return kBottom + y_.share_of(y) * (kTop - kBottom); }

  void line(const std::string& text) { text_ += text + '\n'; }

  void write_text(double x, double y, const std::string& text, Rgb color, const std::string& where = "left",
                  int size = 20);

  /// A data block of lines, and its name.
  std::string block(const std::string& lines);

  void plot(const std::string& what) { plots_ += (plots_.empty() ? "" : ", \\\n     ") + what; }

  std::string finish() const { return text_ + data_ + "plot " + plots_ + '\n'; }

 private:
  Ground ground_;
  GroundStyle style_;
  Range x_, y_;
  std::string text_, data_, plots_;
  int blocks_ = 0;
};

/// Text in gnuplot's single quotes.
std::string quoted_text(const std::string& text);

/// "rgb '#0072B2'"
std::string rgb(Rgb color);

}  // namespace ballpit
