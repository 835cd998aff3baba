// SPDX-License-Identifier: MIT
#include "lab/charts/chart_script.h"

#include <algorithm>

namespace ballpit {

namespace {

/// [widths of the picture] about
double width_of(const std::string& text) {
  const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };  // a character of UTF-8
  return 10.5 / kChartWidth * static_cast<double>(std::count_if(text.begin(), text.end(), starts));
}

void move_apart(Label& below, Label& above) {
  const double gap = above.y - below.y;
  const bool is_beside = below.x + width_of(below.text) < above.x || above.x + width_of(above.text) < below.x;
  if (gap >= kLabelHeight || is_beside) return;
  below.y -= (kLabelHeight - gap) / 2;
  above.y += (kLabelHeight - gap) / 2;
}

}  // namespace

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string data_line(std::initializer_list<double> numbers) { return fmt::format("{}\n", fmt::join(numbers, " ")); }

std::string quoted_text(std::string_view text) { return "'" + replaced(std::string(text), "'", "''") + "'"; }

std::string rgb(Rgb color) { return "rgb '" + hex(color) + "'"; }

void ChartScript::write_text(double x, double y, const std::string& text, Rgb color, std::string_view where,
                             double size) {
  line("set label {} at screen {}, screen {} {} font ',{}' textcolor {}", quoted_text(text), x, y, where, size,
       rgb(color));
}

void ChartScript::write_labels(std::vector<Label> labels) {
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  for (int pass = 0; pass < 200; ++pass) {
    for (size_t a = 0; a < labels.size(); ++a) {
      for (size_t b = a + 1; b < labels.size(); ++b) move_apart(labels[a], labels[b]);
    }
    for (Label& label : labels) label.y = std::clamp(label.y, kPlotBottom - 0.02, kPlotTop + 0.04);
  }
  line("set style textbox opaque noborder margins 0.15, 0 fillcolor {}", rgb(style_.background));
  for (const Label& label : labels) write_text(label.x, label.y, label.text, label.color, "left front boxed");
}

std::string ChartScript::block(const std::string& lines) {
  const std::string name = fmt::format("$d{}", ++blocks_);
  data_ += name + " << EOD\n" + lines + "EOD\n";
  return name;
}

}  // namespace ballpit
