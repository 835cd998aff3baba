// SPDX-License-Identifier: MIT
#include "lab/charts/chart_map.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ballpit {

namespace {

constexpr size_t kMaxMarkedCells = 600;  // beyond that, markers are too small to see

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
      const std::string center = data_line({map.x[column], map.y[row]});
      if (std::isinf(value)) failed += center;
      if (!map.categories.empty() && std::isfinite(value)) markers[static_cast<size_t>(value)] += center;
      cells += script_text("{} {} {} {} {} {} {}\n", map.x[column], map.y[row], x[column], x[column + 1], y[row],
                           y[row + 1], cell_color(script.ground(), map, colors, value));
    }
  }
  if (!cells.empty()) {
    script.plot(script.block(cells),
                " using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid 1 noborder linecolor rgb variable");
  }
  if (map.x.size() * map.y.size() > kMaxMarkedCells) return;
  const auto mark = [&](const std::string& centers, int type) {
    if (centers.empty()) return;
    script.plot(script.block(centers), " with points pointtype {} pointsize 0.7 linewidth 2 linecolor {}", type,
                rgb(script.style().background));
  };
  for (size_t k = 0; k < markers.size(); ++k) mark(markers[k], style_of(map.categories[k].role).open);
  mark(failed, 2);
}

void draw_color_bar(ChartScript& script, const Map& map, const Range& colors) {
  constexpr int kSteps = 48;
  constexpr double kBarLeft = 0.755, kBarRight = 0.785, kBarTop = 0.72;
  const auto height = [&](int step) { return kPlotBottom + (kBarTop - kPlotBottom) * step / kSteps; };
  for (int k = 0; k < kSteps; ++k) {
    script.line(
        "set object rectangle from screen {}, screen {} to screen {}, screen {} fillcolor {} fillstyle solid 1 "
        "noborder",
        kBarLeft, height(k), kBarRight, std::min(height(k + 1) + 0.004, kBarTop), rgb(gradient((k + 0.5) / kSteps)));
  }
  for (const Tick& tick : ticks_of(colors)) {
    script.write_text(kBarRight + 0.012, kPlotBottom + (kBarTop - kPlotBottom) * colors.share_of(tick.at), tick.text,
                      script.style().text);
  }
  script.write_text(kBarLeft, kBarTop + 0.05, map.colors.label, script.style().text);
}

/// Marker and name of each category, the first at the top.
void list_categories(ChartScript& script, const Map& map) {
  double y = kPlotTop - 0.03;
  for (const Category& category : map.categories) {
    script.write_text(kPlotRight + 0.02, y, std::string(style_of(category.role).glyph) + ' ' + category.label,
                      text_color_of(category.role, script.ground()));
    y -= 1.3 * kLabelHeight;
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
  std::vector<double> values;
  for (const std::vector<double>& row : map.values) values.insert(values.end(), row.begin(), row.end());
  const Range colors = range_of(map.colors, values, false);
  draw_cells(script, map, colors);
  if (map.categories.empty()) {
    draw_color_bar(script, map, colors);
  } else {
    list_categories(script, map);
  }
}

}  // namespace ballpit
