// SPDX-License-Identifier: MIT
#include "lab/charts/chart_labels.h"

#include <algorithm>

namespace ballpit {

namespace {

/// About, in widths of the picture.
double width_of(const std::string& text) {
  const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };  // of UTF-8's characters
  return 10.5 / kChartWidth * static_cast<double>(std::count_if(text.begin(), text.end(), starts));
}

void part(Label& below, Label& above) {
  const double gap = above.y - below.y;
  const bool is_beside = below.x + width_of(below.text) < above.x || above.x + width_of(above.text) < below.x;
  if (gap >= kLineHeight || is_beside) return;
  below.y -= (kLineHeight - gap) / 2;
  above.y += (kLineHeight - gap) / 2;
}

}  // namespace

void write_labels(ChartScript& script, std::vector<Label> labels) {
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  for (int pass = 0; pass < 200; ++pass) {
    for (size_t a = 0; a < labels.size(); ++a) {
      for (size_t b = a + 1; b < labels.size(); ++b) part(labels[a], labels[b]);
    }
    for (Label& label : labels) label.y = std::clamp(label.y, kBottom - 0.02, kTop + 0.04);
  }
  script.line("set style textbox opaque noborder margins 0.15, 0 fillcolor " + rgb(script.style().background));
  for (const Label& label : labels) script.write_text(label.x, label.y, label.text, label.color, "left front boxed");
}

}  // namespace ballpit
