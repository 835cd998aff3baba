// SPDX-License-Identifier: MIT
#include "lab/charts/chart.h"

#include <algorithm>
#include <ranges>

#include "core/language.h"
#include "lab/charts/chart_script.h"

namespace ballpit {

namespace {

constexpr double kLabelGap = 0.014;      // [widths of the picture] between the end of a line and its label
constexpr size_t kMaxMarkedCells = 600;  // beyond that, markers are too small to see

/// Borders of cells, half way between their centres; on a logarithmic axis, by ratio.
std::vector<double> edges_of(const std::vector<double>& centers, Scale scale) {
  const auto beyond = [&](double a, double b, double share) {
    return scale == Scale::log ? a * std::pow(b / a, share) : a + share * (b - a);
  };
  if (centers.size() < 2) return {beyond(centers[0], centers[0] * 2, -0.5), beyond(centers[0], centers[0] * 2, 0.5)};
  std::vector<double> edges{beyond(centers[0], centers[1], -0.5)};
  for (size_t k = 0; k + 1 < centers.size(); ++k) edges.push_back(beyond(centers[k], centers[k + 1], 0.5));
  edges.push_back(beyond(centers[centers.size() - 2], centers.back(), 1.5));
  return edges;
}

/// The ranges of all values, error bars and bounds, or of the cells of the map.
std::pair<AxisRange, AxisRange> ranges_of(const Chart& chart) {
  std::vector<double> x, y;
  if (chart.map) {
    x = edges_of(chart.map->x, chart.x.scale);
    y = edges_of(chart.map->y, chart.y.scale);
  } else {
    for (const Series& series : chart.series) {
      for (const Point& point : series.points) {
        x.insert(x.end(), {point.x, point.left, point.right});
        y.insert(y.end(), {point.y, point.low, point.high});
      }
    }
    for (const Bound& bound : chart.bounds) x.push_back(bound.x);
  }
  return {range_of(chart.x, x, !chart.map), range_of(chart.y, y, !chart.map)};
}

/// A series as lines of data blocks.
struct SeriesData {
  std::string points, spreads, x_spreads, failed;
  const Point* last_failed = nullptr;
  const Point* last_shown = nullptr;
};

SeriesData data_of(const Series& series, const AxisRange& x, const AxisRange& y) {
  SeriesData data;
  for (const Point& point : series.points) {
    if (std::isinf(point.y)) {
      data.last_failed = &point;
      data.failed += data_line({point.x, y.high});
      continue;
    }
    if (std::isnan(point.y)) {
      data.points += '\n';
      continue;
    }
    data.points += data_line({point.x, point.y});
    if (!std::isnan(point.low) && !std::isnan(point.high)) {
      data.spreads += data_line({point.x, point.y, std::max(point.low, y.low), std::min(point.high, y.high)});
    }
    if (!std::isnan(point.left) && !std::isnan(point.right)) {
      data.x_spreads += data_line({point.x, point.y, std::max(point.left, x.low), std::min(point.right, x.high)});
    }
    if (x.shows(point.x) && y.shows(point.y)) data.last_shown = &point;
  }
  return data;
}

/// Writes the script of one chart, part by part.
class ChartWriter {
 public:
  ChartWriter(const Chart& chart, Ground ground)
      : chart_(chart), script_(ground, ranges_of(chart)), style_(script_.style()) {}

  std::string write() {
    begin();
    draw_bounds();
    if (chart_.map) draw_map(*chart_.map);
    for (const Series& series : chart_.series) draw(series);
    if (chart_.lists_points) list_points();
    script_.write_labels(std::move(labels_));
    return script_.finish();
  }

 private:
  void begin() {
    script_.line(
        "set terminal svg size {},{} dynamic noenhanced font 'sans-serif,20' background '{}' linewidth 1\n"
        "set encoding utf8\nset key off\nset border 3 linewidth 1.5 linecolor {}",
        kChartWidth, kChartHeight, hex(style_.background), rgb(style_.theory));
    script_.line("set lmargin at screen {}\nset rmargin at screen {}", kPlotLeft, kPlotRight);
    script_.line("set bmargin at screen {}\nset tmargin at screen {}", kPlotBottom, kPlotTop);
    draw_axis("x", script_.x());
    draw_axis("y", script_.y());
    if (!chart_.map) script_.line("set grid xtics ytics linetype 1 linewidth 1 linecolor {}", rgb(style_.faint));
    script_.write_text(0.02, 0.945, chart_.title, style_.text, "left", 24);
    script_.write_text(0.02, 0.865, title_of(chart_.y), style_.text);
    script_.write_text((kPlotLeft + kPlotRight) / 2, 0.03, title_of(chart_.x), style_.text, "center");
  }

  void draw_axis(const std::string& name, const AxisRange& range) {
    if (range.scale == Scale::log) script_.line("set logscale {}", name);
    script_.line("set {}range [{}:{}]", name, range.low, range.high);
    std::string ticks;
    for (const Tick& tick : ticks_of(range)) {
      ticks += fmt::format("{}{} {}", ticks.empty() ? "" : ", ", quoted_text(tick.text), tick.at);
    }
    script_.line("set {}tics scale 0.5 nomirror out textcolor {} ({})", name, rgb(style_.text), ticks);
  }

  void draw_bounds() {
    for (const Bound& bound : chart_.bounds) {
      script_.line(
          "set arrow from first {0}, graph 0 to first {0}, graph 1 nohead dashtype 2 linewidth 1.5 linecolor {1}",
          bound.x, rgb(style_.theory));
      script_.line("set label {} at first {}, graph 1.025 center font ',16' textcolor {}", quoted_text(bound.label),
                   bound.x, rgb(style_.theory));
    }
  }

  void draw(const Series& series) {
    const bool is_theory = series.role == "theory";
    const Rgb color = is_theory && chart_.map ? style_.text : color_of(series.role, script_.ground());
    const SeriesData data = data_of(series, script_.x(), script_.y());
    for (const auto& [lines, axis] : {std::pair{&data.x_spreads, 'x'}, std::pair{&data.spreads, 'y'}}) {
      if (lines->empty()) continue;
      script_.plot(script_.block(*lines), " with {}errorbars pointtype 0 linewidth 1.5 linecolor {}", axis, rgb(color));
    }
    if (!data.points.empty()) draw_points(series, color, script_.block(data.points));
    if (data.last_failed != nullptr) {
      script_.plot(script_.block(data.failed), " with points pointtype 2 pointsize 1.2 linewidth 3 linecolor {}",
                   rgb(color_of("failed", script_.ground())));
      label_failed(data.last_failed->x);
    }
    if (chart_.lists_points && series.stroke == Stroke::points) return;
    if (data.last_shown != nullptr && !series.label.empty()) add_label(series, *data.last_shown, color);
  }

  void add_label(const Series& series, const Point& end, Rgb color) {
    const bool is_theory = series.role == "theory";
    const std::string with_marker = std::string(style_of(series.role).glyph) + ' ' + series.label;
    if (chart_.map) {
      script_.write_text(0.98, kPlotTop + 0.065, with_marker, color, "right");
      return;
    }
    labels_.push_back({script_.place_x(end.x) + kLabelGap, script_.place_y(end.y),
                       series.stroke == Stroke::line || is_theory ? series.label : with_marker,
                       is_theory ? style_.theory : text_color_of(series.role, script_.ground())});
  }

  /// Marker and label of each series of points, beside the lower right corner of the plot; the upper one is where lines
  /// end.
  void list_points() {
    double y = kPlotBottom;
    for (const Series& series : chart_.series | std::views::reverse) {
      if (series.stroke != Stroke::points || series.points.empty()) continue;
      labels_.push_back({kPlotRight + kLabelGap, y, std::string(style_of(series.role).glyph) + ' ' + series.label,
                         text_color_of(series.role, script_.ground())});
      y += 1.15 * kLabelHeight;
    }
  }

  /// Explains the crosses once, beside the rightmost of them.
  void label_failed(double x) {
    const double place = script_.place_x(x) + kLabelGap;
    const std::string failed = translated("failed");
    const auto is_failed = [&](const Label& label) { return label.text == failed; };
    const auto found = std::find_if(labels_.begin(), labels_.end(), is_failed);
    if (found != labels_.end()) {
      found->x = std::max(found->x, place);
    } else {
      labels_.push_back({place, kPlotTop, failed, text_color_of("failed", script_.ground())});
    }
  }

  void draw_points(const Series& series, Rgb color, const std::string& data) {
    const bool is_theory = series.role == "theory";
    if (series.stroke != Stroke::points) {
      if (is_theory && chart_.map) {
        script_.plot(data, " with lines linewidth 6 linecolor {}", rgb(style_.background));
      }
      script_.plot(data, " with lines{} linewidth {} linecolor {}",
                   is_theory          ? " dashtype 3"
                   : series.is_dashed ? " dashtype 2"
                                      : "",
                   series.is_thin ? 1.2 : 3.0, rgb(color));
    }
    if (is_theory || series.stroke == Stroke::line) return;
    const RoleStyle& role = style_of(series.role);
    const double size = series.is_thin ? 0.6 : 0.95;
    script_.plot(data, " with points pointtype {} pointsize {} linecolor {}", role.filled, size,
                 rgb(style_.background));
    script_.plot(data, " with points pointtype {} pointsize {} linewidth 2.5 linecolor {}", role.open, size,
                 rgb(color));
  }

  void draw_map(const Map& map) {
    std::vector<double> values;
    for (const std::vector<double>& row : map.values) values.insert(values.end(), row.begin(), row.end());
    const AxisRange colors = range_of(map.colors, values, false);
    draw_cells(map, colors);
    if (map.categories.empty()) {
      draw_color_bar(map, colors);
    } else {
      list_categories(map);
    }
  }

  Rgb cell_color(const Map& map, const AxisRange& colors, double value) const {
    if (std::isinf(value)) return color_of("failed", script_.ground());
    if (map.categories.empty()) return gradient(colors.share_of(value));
    return color_of(map.categories[static_cast<size_t>(value)].role, script_.ground());
  }

  void draw_cells(const Map& map, const AxisRange& colors) {
    const std::vector<double> x = edges_of(map.x, chart_.x.scale), y = edges_of(map.y, chart_.y.scale);
    std::string cells, failed;
    std::vector<std::string> markers(map.categories.size());
    for (size_t row = 0; row < map.y.size(); ++row) {
      for (size_t column = 0; column < map.x.size(); ++column) {
        const double value = map.values[row][column];
        if (std::isnan(value)) continue;
        const std::string center = data_line({map.x[column], map.y[row]});
        if (std::isinf(value)) failed += center;
        if (!map.categories.empty() && std::isfinite(value)) markers[static_cast<size_t>(value)] += center;
        cells += fmt::format("{} {} {} {} {} {} {}\n", map.x[column], map.y[row], x[column], x[column + 1], y[row],
                             y[row + 1], cell_color(map, colors, value));
      }
    }
    if (!cells.empty()) {
      script_.plot(script_.block(cells),
                   " using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid 1 noborder linecolor rgb variable");
    }
    if (map.x.size() * map.y.size() > kMaxMarkedCells) return;
    const auto mark = [&](const std::string& centers, int type) {
      if (centers.empty()) return;
      script_.plot(script_.block(centers), " with points pointtype {} pointsize 0.7 linewidth 2 linecolor {}", type,
                   rgb(style_.background));
    };
    for (size_t k = 0; k < markers.size(); ++k) mark(markers[k], style_of(map.categories[k].role).open);
    mark(failed, 2);
  }

  void draw_color_bar(const Map& map, const AxisRange& colors) {
    constexpr int kSteps = 48;
    constexpr double kBarLeft = 0.755, kBarRight = 0.785, kBarTop = 0.72;
    const auto height = [&](double share) { return kPlotBottom + (kBarTop - kPlotBottom) * share; };
    for (int k = 0; k < kSteps; ++k) {
      script_.line(
          "set object rectangle from screen {}, screen {} to screen {}, screen {} fillcolor {} fillstyle solid 1 "
          "noborder",
          kBarLeft, height(1.0 * k / kSteps), kBarRight, std::min(height((k + 1.0) / kSteps) + 0.004, kBarTop),
          rgb(gradient((k + 0.5) / kSteps)));
    }
    for (const Tick& tick : ticks_of(colors)) {
      script_.write_text(kBarRight + 0.012, height(colors.share_of(tick.at)), tick.text, style_.text);
    }
    script_.write_text(kBarLeft, kBarTop + 0.05, map.colors.label, style_.text);
  }

  /// Marker and name of each category, the first at the top.
  void list_categories(const Map& map) {
    double y = kPlotTop - 0.03;
    for (const Category& category : map.categories) {
      script_.write_text(kPlotRight + 0.02, y, std::string(style_of(category.role).glyph) + ' ' + category.label,
                         text_color_of(category.role, script_.ground()));
      y -= 1.3 * kLabelHeight;
    }
  }

  const Chart& chart_;
  ChartScript script_;
  const GroundStyle& style_;
  std::vector<Label> labels_;
};

}  // namespace

std::string gnuplot_script(const Chart& chart, Ground ground) { return ChartWriter(chart, ground).write(); }

}  // namespace ballpit
