// SPDX-License-Identifier: MIT
#include "lab/charts/chart_map.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/input_error.h"

namespace ballpit {

namespace {

constexpr size_t kMostMarkedCells = 600;  // in more, markers are too small to see

std::vector<double> all_of(const Map& map) {
  std::vector<double> values;
  for (const std::vector<double>& row : map.values) values.insert(values.end(), row.begin(), row.end());
  return values;
}

Rgb cell_color(Ground ground, const Map& map, const Range& colors, double value) {
  if (std::isinf(value)) return color_of("failed", ground);
  if (!map.categories.empty()) return color_of(map.categories[static_cast<size_t>(value)].role, ground);
  return gradient(colors.share_of(value));
}

void draw_cells(ChartScript& script, const Map& map, const Range& colors) {
  const std::vector<double> x = edges_of(map.x, script.x().scale), y = edges_of(map.y, script.y().scale);
  std::string cells, failed;
  std::vector<std::string> markers(map.categories.size());
  for (size_t row = 0; row < map.y.size(); ++row) {
    for (size_t column = 0; column < map.x.size(); ++column) {
      const double value = map.values[row][column];
      if (std::isnan(value)) continue;
      const std::string center = number_text(map.x[column]) + ' ' + number_text(map.y[row]);
      if (std::isinf(value)) failed += center + '\n';
      if (!map.categories.empty() && std::isfinite(value)) markers[static_cast<size_t>(value)] += center + '\n';
      cells += center + ' ' + number_text(x[column]) + ' ' + number_text(x[column + 1]) + ' ' + number_text(y[row]) +
               ' ' + number_text(y[row + 1]) + ' ' + std::to_string(cell_color(script.ground(), map, colors, value)) +
               '\n';
    }
  }
  if (!cells.empty()) {
    script.plot(script.block(cells) +
                " using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid 1 noborder linecolor rgb variable");
  }
  const bool is_marked = map.x.size() * map.y.size() <= kMostMarkedCells;
  for (size_t k = 0; k < markers.size(); ++k) {
    if (!is_marked || markers[k].empty()) continue;
    script.plot(script.block(markers[k]) + " with points pointtype " +
                std::to_string(style_of(map.categories[k].role).open) + " pointsize 0.7 linewidth 2 linecolor " +
                rgb(script.style().background));
  }
  if (!failed.empty() && is_marked) {
    script.plot(script.block(failed) + " with points pointtype 2 pointsize 0.7 linewidth 2 linecolor " +
                rgb(script.style().background));
  }
}

void draw_color_bar(ChartScript& script, const Map& map, const Range& colors) {
  constexpr int kSteps = 48;
  constexpr double kBarLeft = 0.755, kBarRight = 0.785, kBarTop = 0.72;
  for (int k = 0; k < kSteps; ++k) {
    const auto height = [&](int step) { return kBottom + (kBarTop - kBottom) * step / kSteps; };
    script.line("set object rectangle from screen " + number_text(kBarLeft) + ", screen " + number_text(height(k)) +
                " to screen " + number_text(kBarRight) + ", screen " +
                number_text(std::min(height(k + 1) + 0.004, kBarTop)) + " fillcolor " +
                rgb(gradient((k + 0.5) / kSteps)) + " fillstyle solid 1 noborder");
  }
  for (const Tick& tick : ticks_of(colors)) {
    script.write_text(kBarRight + 0.012, kBottom + (kBarTop - kBottom) * colors.share_of(tick.at), tick.text,
                      script.style().text);
  }
  script.write_text(kBarLeft, kBarTop + 0.05, map.label, script.style().text);
}

/// A chip for each category, the first at the top.
void list_categories(ChartScript& script, const Map& map) {
  double y = kTop - 0.03;
  for (const Category& category : map.categories) {
    script.write_text(kRight + 0.02, y, std::string(style_of(category.role).glyph) + ' ' + category.label,
                      text_color_of(category.role, script.ground()));
    y -= 1.3 * kLineHeight;
  }
}

}  // namespace

std::vector<double> edges_of(const std::vector<double>& centers, Scale scale) {
  const auto between = [&](double a, double b, double share) {
    return scale == Scale::log ? a * std::pow(b / a, share) : a + share * (b - a);
  };
  if (centers.size() < 2) return {between(centers[0], centers[0] * 2, -0.5), between(centers[0], centers[0] * 2, 0.5)};
  std::vector<double> edges{between(centers[0], centers[1], -0.5)};
  for (size_t k = 0; k + 1 < centers.size(); ++k) edges.push_back(between(centers[k], centers[k + 1], 0.5));
  edges.push_back(between(centers[centers.size() - 2], centers.back(), 1.5));
  return edges;
}

void draw_map(ChartScript& script, const Map& map) {
  const Range colors =
      range_of({"", "", map.is_log ? Scale::log : Scale::linear, map.low, map.high}, all_of(map), false);
  draw_cells(script, map, colors);
  if (map.categories.empty()) {
    draw_color_bar(script, map, colors);
  } else {
    list_categories(script, map);
  }
}

}  // namespace ballpit
