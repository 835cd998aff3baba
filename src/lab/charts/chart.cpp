// SPDX-License-Identifier: MIT
#include "lab/charts/chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/charts/chart_map.h"
#include "lab/charts/chart_script.h"

namespace ballpit {

namespace {

constexpr double kLabelGap = 0.014;  // [widths of the picture] between the end of a line and its label

Range range_of_x(const Chart& chart) {
  if (chart.map) return range_of(chart.x, edges_of(chart.map->x, chart.x.scale), false);
  std::vector<double> values;
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) values.insert(values.end(), {point.x, point.left, point.right});
  }
  for (const Bound& bound : chart.bounds) values.push_back(bound.x);
  return range_of(chart.x, values, true);
}

Range range_of_y(const Chart& chart) {
  if (chart.map) return range_of(chart.y, edges_of(chart.map->y, chart.y.scale), false);
  std::vector<double> values;
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) values.insert(values.end(), {point.y, point.low, point.high});
  }
  return range_of(chart.y, values, true);
}

/// A series as lines of data blocks.
struct SeriesData {
  std::string points, spreads, x_spreads, failed;
  const Point* last_failed = nullptr;
  const Point* last_shown = nullptr;
};

SeriesData data_of(const Series& series, const Range& x, const Range& y) {
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
      : chart_(chart), script_(ground, range_of_x(chart), range_of_y(chart)), style_(script_.style()) {}

  std::string write() {
    begin();
    draw_bounds();
    if (chart_.map) draw_map(script_, *chart_.map);
    for (const Series& series : chart_.series) draw(series);
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

  void draw_axis(const std::string& name, const Range& range) {
    if (range.scale == Scale::log) script_.line("set logscale {}", name);
    script_.line("set {}range [{}:{}]", name, range.low, range.high);
    std::string ticks;
    for (const Tick& tick : ticks_of(range)) {
      ticks += script_text("{}{} {}", ticks.empty() ? "" : ", ", quoted_text(tick.text), tick.at);
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

  /// Explains the crosses once, beside the rightmost of them.
  void label_failed(double x) {
    const double place = script_.place_x(x) + kLabelGap;
    const auto is_failed = [](const Label& label) { return label.text == "failed"; };
    const auto found = std::find_if(labels_.begin(), labels_.end(), is_failed);
    if (found != labels_.end()) {
      found->x = std::max(found->x, place);
    } else {
      labels_.push_back({place, kPlotTop, "failed", text_color_of("failed", script_.ground())});
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

  const Chart& chart_;
  ChartScript script_;
  const GroundStyle& style_;
  std::vector<Label> labels_;
};

}  // namespace

std::string gnuplot_script(const Chart& chart, Ground ground) { return ChartWriter(chart, ground).write(); }

}  // namespace ballpit
