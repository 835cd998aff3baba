// SPDX-License-Identifier: MIT
#include "lab/charts/chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/charts/chart_labels.h"
#include "lab/charts/chart_map.h"
#include "lab/charts/chart_script.h"
#include "scene/input_error.h"

namespace ballpit {

namespace {

constexpr double kLabelGap = 0.014;  // [widths of the picture] between a line's end and its label

Range range_of_x(const Chart& chart) {
  std::vector<double> values;
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) values.insert(values.end(), {point.x, point.left, point.right});
  }
  for (const Bound& bound : chart.bounds) values.push_back(bound.x);
  if (chart.map) values = edges_of(chart.map->x, chart.x.scale);
  return range_of(chart.x, values, !chart.map);
}

Range range_of_y(const Chart& chart) {
  std::vector<double> values;
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) values.insert(values.end(), {point.y, point.low, point.high});
  }
  if (chart.map) values = edges_of(chart.map->y, chart.y.scale);
  return range_of(chart.y, values, !chart.map);
}

/// Writes one chart's script, part by part.
class ChartWriter {
 public:
  ChartWriter(const Chart& chart, Ground ground)
      : chart_(chart), script_(ground, range_of_x(chart), range_of_y(chart)) {}

  std::string write() {
    begin();
    draw_bounds();
    if (chart_.map) draw_map(script_, *chart_.map);
    for (const Series& series : chart_.series) draw(series);
    write_labels(script_, std::move(labels_));
    return script_.finish();
  }

 private:
  void begin() {
    script_.line("set terminal svg size " + number_text(kChartWidth) + "," + number_text(kChartHeight) +
                 " dynamic noenhanced font 'sans-serif,20' background '" + hex(script_.style().background) +
                 "' linewidth 1");
    script_.line("set encoding utf8\nset key off\nset border 3 linewidth 1.5 linecolor " + rgb(script_.style().theory));
    script_.line("set lmargin at screen " + number_text(kLeft) + "\nset rmargin at screen " + number_text(kRight));
    script_.line("set bmargin at screen " + number_text(kBottom) + "\nset tmargin at screen " + number_text(kTop));
    axis("x", script_.x());
    axis("y", script_.y());
    if (!chart_.map)
      script_.line("set grid xtics ytics linetype 1 linewidth 1 linecolor " + rgb(script_.style().faint));
    script_.write_text(0.02, 0.945, chart_.title, script_.style().text, "left", 24);
    script_.write_text(0.02, 0.865, title_of(chart_.y), script_.style().text);
    script_.write_text((kLeft + kRight) / 2, 0.03, title_of(chart_.x), script_.style().text, "center");
  }

  void axis(const std::string& name, const Range& range) {
    if (range.scale == Scale::log) script_.line("set logscale " + name);
    script_.line("set " + name + "range [" + number_text(range.low) + ":" + number_text(range.high) + "]");
    std::string ticks;
    for (const Tick& tick : ticks_of(range)) {
      if (!ticks.empty()) ticks += ", ";
      ticks += quoted_text(tick.text) + ' ' + number_text(tick.at);
    }
    script_.line("set " + name + "tics scale 0.5 nomirror out textcolor " + rgb(script_.style().text) + " (" + ticks +
                 ")");
  }

  void draw_bounds() {
    for (const Bound& bound : chart_.bounds) {
      const std::string x = "first " + number_text(bound.x);
      script_.line("set arrow from " + x + ", graph 0 to " + x +
                   ", graph 1 nohead dashtype 2 linewidth 1.5 linecolor " + rgb(script_.style().theory));
      script_.line("set label " + quoted_text(bound.label) + " at " + x + ", graph 1.025 center font ',16' textcolor " +
                   rgb(script_.style().theory));
    }
  }

  void draw(const Series& series) {
    const RoleStyle& role = style_of(series.role);
    const bool is_theory = series.role == "theory";
    const Rgb color = is_theory && chart_.map ? script_.style().text : color_of(series.role, script_.ground());
    std::string points, spreads, x_spreads, failed;
    double failed_at = 0;
    const Point* last = nullptr;
    for (const Point& point : series.points) {
      if (std::isinf(point.y)) {
        failed_at = point.x;
        failed += number_text(point.x) + ' ' + number_text(script_.y().high) + '\n';
        continue;
      }
      if (std::isnan(point.y)) {
        points += '\n';
        continue;
      }
      points += number_text(point.x) + ' ' + number_text(point.y) + '\n';
      if (!std::isnan(point.low) && !std::isnan(point.high)) {
        spreads += number_text(point.x) + ' ' + number_text(point.y) + ' ' +
                   number_text(std::max(point.low, script_.y().low)) + ' ' +
                   number_text(std::min(point.high, script_.y().high)) + '\n';
      }
      if (!std::isnan(point.left) && !std::isnan(point.right)) {
        x_spreads += number_text(point.x) + ' ' + number_text(point.y) + ' ' +
                     number_text(std::max(point.left, script_.x().low)) + ' ' +
                     number_text(std::min(point.right, script_.x().high)) + '\n';
      }
      if (script_.x().shows(point.x) && script_.y().shows(point.y)) last = &point;
    }
    if (!x_spreads.empty()) {
      script_.plot(script_.block(x_spreads) + " with xerrorbars pointtype 0 linewidth 1.5 linecolor " + rgb(color));
    }
    if (!spreads.empty()) {
      script_.plot(script_.block(spreads) + " with yerrorbars pointtype 0 linewidth 1.5 linecolor " + rgb(color));
    }
    if (!points.empty()) draw_points(series, role, color, script_.block(points));
    if (!failed.empty()) {
      script_.plot(script_.block(failed) + " with points pointtype 2 pointsize 1.2 linewidth 3 linecolor " +
                   rgb(color_of("failed", script_.ground())));
      label_failed(failed_at);
    }
    if (last == nullptr || series.label.empty()) return;
    const bool has_marker = series.stroke == Stroke::points || series.stroke == Stroke::line_and_points;
    if (chart_.map) {
      script_.write_text(0.98, kTop + 0.065, std::string(role.glyph) + ' ' + series.label, color, "right");
      return;
    }
    labels_.push_back({script_.place_x(last->x) + kLabelGap, script_.place_y(last->y),
                       has_marker && !is_theory ? std::string(role.glyph) + ' ' + series.label : series.label,
                       is_theory ? script_.style().theory : text_color_of(series.role, script_.ground())});
  }

  /// Once, beside a cross at the edge: what crosses are.
  void label_failed(double x) {
    const double place = script_.place_x(x) + kLabelGap;
    const auto is_failed = [](const Label& label) { return label.text == "failed"; };
    const auto found = std::find_if(labels_.begin(), labels_.end(), is_failed);
    if (found != labels_.end()) {
      found->x = std::max(found->x, place);
    } else {
      labels_.push_back({place, kTop, "failed", text_color_of("failed", script_.ground())});
    }
  }

  void draw_points(const Series& series, const RoleStyle& role, Rgb color, const std::string& data) {
    const bool is_theory = series.role == "theory";
    if (series.stroke != Stroke::points) {
      const std::string kind = series.stroke == Stroke::steps ? " with histeps" : " with lines";
      const std::string dashes = is_theory ? " dashtype 3" : series.is_dashed ? " dashtype 2" : "";
      const std::string width = series.is_thin ? "1.2" : "3";
      if (is_theory && chart_.map)
        script_.plot(data + kind + " linewidth 6 linecolor " + rgb(script_.style().background));
      script_.plot(data + kind + dashes + " linewidth " + width + " linecolor " + rgb(color));
    }
    if (is_theory || series.stroke == Stroke::line || series.stroke == Stroke::steps) return;
    const std::string size = series.is_thin ? "0.6" : "0.95";
    script_.plot(data + " with points pointtype " + std::to_string(role.filled) + " pointsize " + size + " linecolor " +
                 rgb(script_.style().background));
    script_.plot(data + " with points pointtype " + std::to_string(role.open) + " pointsize " + size +
                 " linewidth 2.5 linecolor " + rgb(color));
  }

  const Chart& chart_;
  ChartScript script_;
  std::vector<Label> labels_;
};

}  // namespace

std::string gnuplot_script(const Chart& chart, Ground ground) { return ChartWriter(chart, ground).write(); }

}  // namespace ballpit
