// SPDX-License-Identifier: MIT
#include "lab/chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "lab/chart_axis.h"
#include "lab/chart_style.h"
#include "scene/input_error.h"

namespace ballpit {

namespace {

constexpr double kWidth = 720, kHeight = 520;                               // [px]
constexpr double kLeft = 0.12, kRight = 0.725, kBottom = 0.155, kTop = 0.8;  // of the picture: where the axes are
constexpr double kLineHeight = 0.046;                                       // of a label, in heights of the picture
constexpr size_t kMostMarkedCells = 600;  // of a map of categories: in more, markers are too small to see

/// Text in gnuplot's single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c;
    if (c == '\'') result += c;
  }
  return result + '\'';
}

std::string rgb(Rgb color) { return "rgb '" + hex(color) + "'"; }

/// Borders of cells: half way between centres, by ratio where the axis is logarithmic.
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

/// Writes one chart's script, part by part.
class Script {
 public:
  Script(const Chart& chart, Ground ground)
      : chart_(chart), ground_(ground), style_(ground_style(ground)), x_(range_of_x()), y_(range_of_y()) {}

  std::string write() {
    begin();
    draw_bounds();
    if (chart_.map) draw_map(*chart_.map);
    for (const Series& series : chart_.series) draw(series);
    place_labels();
    return text_ + data_ + "plot " + plots_ + "\n";
  }

 private:
  struct Label {
    double x, y;  ///< of the picture, y up
    std::string text;
    Rgb color;
  };

  Range range_of_x() const {
    std::vector<double> values;
    for (const Series& series : chart_.series) {
      for (const Point& point : series.points) values.insert(values.end(), {point.x, point.left, point.right});
    }
    for (const Bound& bound : chart_.bounds) values.push_back(bound.x);
    if (chart_.map) values = edges_of(chart_.map->x, chart_.x.scale);
    return range_of(chart_.x, values, !chart_.map);
  }

  Range range_of_y() const {
    std::vector<double> values;
    for (const Series& series : chart_.series) {
      for (const Point& point : series.points) values.insert(values.end(), {point.y, point.low, point.high});
    }
    if (chart_.map) values = edges_of(chart_.map->y, chart_.y.scale);
    return range_of(chart_.y, values, !chart_.map);
  }

  void line(const std::string& text) { text_ += text + '\n'; }

  void begin() {
    line("set terminal svg size " + number_text(kWidth) + "," + number_text(kHeight) +
         " dynamic noenhanced font 'sans-serif,20' background '" + hex(style_.background) + "' linewidth 1");
    line("set encoding utf8\nset key off\nset border 3 linewidth 1.5 linecolor " + rgb(style_.theory));
    line("set lmargin at screen " + number_text(kLeft) + "\nset rmargin at screen " + number_text(kRight));
    line("set bmargin at screen " + number_text(kBottom) + "\nset tmargin at screen " + number_text(kTop));
    axis("x", x_);
    axis("y", y_);
    if (!chart_.map) line("set grid xtics ytics linetype 1 linewidth 1 linecolor " + rgb(style_.faint));
    write_text(0.02, 0.945, chart_.title, style_.text, "left", 24);
    write_text(0.02, 0.865, title_of(chart_.y), style_.text);
    write_text((kLeft + kRight) / 2, 0.03, title_of(chart_.x), style_.text, "center");
  }

  void axis(const std::string& name, const Range& range) {
    if (range.scale == Scale::log) line("set logscale " + name);
    line("set " + name + "range [" + number_text(range.low) + ":" + number_text(range.high) + "]");
    std::string ticks;
    for (const Tick& tick : ticks_of(range)) {
      if (!ticks.empty()) ticks += ", ";
      ticks += quoted(tick.text) + ' ' + number_text(tick.at);
    }
    line("set " + name + "tics scale 0.5 nomirror out textcolor " + rgb(style_.text) + " (" + ticks + ")");
  }

  void write_text(double x, double y, const std::string& text, Rgb color, const std::string& where = "left",
                  int size = 20) {
    line("set label " + quoted(text) + " at screen " + number_text(x) + ", screen " + number_text(y) + ' ' + where +
         " font '," + std::to_string(size) + "' textcolor " + rgb(color));
  }

  void draw_bounds() {
    for (const Bound& bound : chart_.bounds) {
      const std::string x = "first " + number_text(bound.x);
      line("set arrow from " + x + ", graph 0 to " + x + ", graph 1 nohead dashtype 2 linewidth 1.5 linecolor " +
           rgb(style_.theory));
      line("set label " + quoted(bound.label) + " at " + x + ", graph 1.025 center font ',16' textcolor " +
           rgb(style_.theory));
    }
  }

  /// A data block of lines, and its name.
  std::string block(const std::string& lines) {
    const std::string name = "$d" + std::to_string(++blocks_);
    data_ += name + " << EOD\n" + lines + "EOD\n";
    return name;
  }

  void plot(const std::string& what) { plots_ += (plots_.empty() ? "" : ", \\\n     ") + what; }

  void draw(const Series& series) {
    const RoleStyle& role = style_of(series.role);
    const bool is_theory = series.role == "theory";
    const Rgb color = is_theory && chart_.map ? style_.text : color_of(series.role, ground_);
    std::string points, spreads, x_spreads, failed;
    double failed_at = 0;
    const Point* last = nullptr;
    for (const Point& point : series.points) {
      if (std::isinf(point.y)) {
        failed_at = point.x;
        failed += number_text(point.x) + ' ' + number_text(y_.high) + '\n';
        continue;
      }
      if (std::isnan(point.y)) {
        points += '\n';
        continue;
      }
      points += number_text(point.x) + ' ' + number_text(point.y) + '\n';
      if (!std::isnan(point.low) && !std::isnan(point.high)) {
        spreads += number_text(point.x) + ' ' + number_text(point.y) + ' ' + number_text(std::max(point.low, y_.low)) +
                   ' ' + number_text(std::min(point.high, y_.high)) + '\n';
      }
      if (!std::isnan(point.left) && !std::isnan(point.right)) {
        x_spreads += number_text(point.x) + ' ' + number_text(point.y) + ' ' +
                     number_text(std::max(point.left, x_.low)) + ' ' + number_text(std::min(point.right, x_.high)) +
                     '\n';
      }
      if (x_.shows(point.x) && y_.shows(point.y)) last = &point;
    }
    if (!x_spreads.empty()) {
      plot(block(x_spreads) + " with xerrorbars pointtype 0 linewidth 1.5 linecolor " + rgb(color));
    }
    if (!spreads.empty()) {
      plot(block(spreads) + " with yerrorbars pointtype 0 linewidth 1.5 linecolor " + rgb(color));
    }
    if (!points.empty()) draw_points(series, role, color, block(points));
    if (!failed.empty()) {
      plot(block(failed) + " with points pointtype 2 pointsize 1.2 linewidth 3 linecolor " +
           rgb(color_of("failed", ground_)));
      label_failed(failed_at);
    }
    if (last == nullptr || series.label.empty()) return;
    const bool has_marker = series.stroke == Stroke::points || series.stroke == Stroke::line_and_points;
    if (chart_.map) {
      write_text(0.98, kTop + 0.065, std::string(role.glyph) + ' ' + series.label, color, "right");
      return;
    }
    labels_.push_back({kLeft + x_.share_of(last->x) * (kRight - kLeft) + 0.014,
                       kBottom + y_.share_of(last->y) * (kTop - kBottom),
                       has_marker && !is_theory ? std::string(role.glyph) + ' ' + series.label : series.label,
                       is_theory ? style_.theory : text_color_of(series.role, ground_)});
  }

  /// Once, beside a cross at the edge: what crosses are.
  void label_failed(double x) {
    const double place = kLeft + x_.share_of(x) * (kRight - kLeft) + 0.014;
    const auto is_failed = [](const Label& label) { return label.text == "failed"; };
    const auto found = std::find_if(labels_.begin(), labels_.end(), is_failed);
    if (found != labels_.end()) {
      found->x = std::max(found->x, place);
    } else {
      labels_.push_back({place, kTop, "failed", text_color_of("failed", ground_)});
    }
  }

  void draw_points(const Series& series, const RoleStyle& role, Rgb color, const std::string& data) {
    const bool is_theory = series.role == "theory";
    if (series.stroke != Stroke::points) {
      const std::string kind = series.stroke == Stroke::steps ? " with histeps" : " with lines";
      const std::string dashes = is_theory ? " dashtype 3" : series.is_dashed ? " dashtype 2" : "";
      const std::string width = series.is_thin ? "1.2" : "3";
      if (is_theory && chart_.map) plot(data + kind + " linewidth 6 linecolor " + rgb(style_.background));
      plot(data + kind + dashes + " linewidth " + width + " linecolor " + rgb(color));
    }
    if (is_theory || series.stroke == Stroke::line || series.stroke == Stroke::steps) return;
    const std::string size = series.is_thin ? "0.6" : "0.95";
    plot(data + " with points pointtype " + std::to_string(role.filled) + " pointsize " + size + " linecolor " +
         rgb(style_.background));
    plot(data + " with points pointtype " + std::to_string(role.open) + " pointsize " + size +
         " linewidth 2.5 linecolor " + rgb(color));
  }

  void draw_map(const Map& map) {
    const std::vector<double> x = edges_of(map.x, chart_.x.scale), y = edges_of(map.y, chart_.y.scale);
    const Range colors =
        range_of({"", "", map.is_log ? Scale::log : Scale::linear, map.low, map.high}, all_of(map), false);
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
                 ' ' + number_text(y[row + 1]) + ' ' + std::to_string(cell_color(map, colors, value)) + '\n';
      }
    }
    if (!cells.empty()) {
      plot(block(cells) + " using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid 1 noborder linecolor rgb variable");
    }
    const bool is_marked = map.x.size() * map.y.size() <= kMostMarkedCells;
    for (size_t k = 0; k < markers.size(); ++k) {
      if (!is_marked || markers[k].empty()) continue;
      plot(block(markers[k]) + " with points pointtype " + std::to_string(style_of(map.categories[k].role).open) +
           " pointsize 0.7 linewidth 2 linecolor " + rgb(style_.background));
    }
    if (!failed.empty() && is_marked) {
      plot(block(failed) + " with points pointtype 2 pointsize 0.7 linewidth 2 linecolor " + rgb(style_.background));
    }
    if (map.categories.empty()) {
      draw_color_bar(map, colors);
    } else {
      list_categories(map);
    }
  }

  static std::vector<double> all_of(const Map& map) {
    std::vector<double> values;
    for (const std::vector<double>& row : map.values) values.insert(values.end(), row.begin(), row.end());
    return values;
  }

  Rgb cell_color(const Map& map, const Range& colors, double value) const {
    if (std::isinf(value)) return color_of("failed", ground_);
    if (!map.categories.empty()) return color_of(map.categories[static_cast<size_t>(value)].role, ground_);
    return gradient(colors.share_of(value));
  }

  void draw_color_bar(const Map& map, const Range& colors) {
    constexpr int kSteps = 48;
    constexpr double kBarLeft = 0.755, kBarRight = 0.785, kBarTop = 0.72;
    for (int k = 0; k < kSteps; ++k) {
      const auto height = [&](int step) { return kBottom + (kBarTop - kBottom) * step / kSteps; };
      line("set object rectangle from screen " + number_text(kBarLeft) + ", screen " + number_text(height(k)) +
           " to screen " + number_text(kBarRight) + ", screen " + number_text(height(k + 1)) + " fillcolor " +
           rgb(gradient((k + 0.5) / kSteps)) + " fillstyle solid 1 noborder");
    }
    for (const Tick& tick : ticks_of(colors)) {
      write_text(kBarRight + 0.012, kBottom + (kBarTop - kBottom) * colors.share_of(tick.at), tick.text, style_.text);
    }
    write_text(kBarLeft, kBarTop + 0.05, map.label, style_.text);
  }

  /// A chip for each category, the first at the top.
  void list_categories(const Map& map) {
    double y = kTop - 0.03;
    for (const Category& category : map.categories) {
      write_text(kRight + 0.02, y, std::string(style_of(category.role).glyph) + ' ' + category.label,
                 text_color_of(category.role, ground_));
      y -= 1.3 * kLineHeight;
    }
  }

  /// Labels that would cover each other move apart, in their order from below, as far as the picture goes. They stand on
  /// ground of their own, so that lines behind them leave them legible.
  void place_labels() {
    std::stable_sort(labels_.begin(), labels_.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
    for (int pass = 0; pass < 200; ++pass) {
      for (size_t a = 0; a < labels_.size(); ++a) {
        for (size_t b = a + 1; b < labels_.size(); ++b) part(labels_[a], labels_[b]);
      }
      for (Label& label : labels_) label.y = std::clamp(label.y, kBottom - 0.02, kTop + 0.04);
    }
    line("set style textbox opaque noborder margins 0.15, 0 fillcolor " + rgb(style_.background));
    for (const Label& label : labels_) write_text(label.x, label.y, label.text, label.color, "left front boxed");
  }

  static void part(Label& below, Label& above) {
    const double gap = above.y - below.y;
    const bool is_beside = below.x + width_of(below.text) < above.x || above.x + width_of(above.text) < below.x;
    if (gap >= kLineHeight || is_beside) return;
    below.y -= (kLineHeight - gap) / 2;
    above.y += (kLineHeight - gap) / 2;
  }

  /// About, in widths of the picture.
  static double width_of(const std::string& text) {
    const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };  // of UTF-8's characters
    return 10.5 / kWidth * static_cast<double>(std::count_if(text.begin(), text.end(), starts));
  }

  const Chart& chart_;
  Ground ground_;
  GroundStyle style_;
  Range x_, y_;
  std::string text_, data_, plots_;
  std::vector<Label> labels_;
  int blocks_ = 0;
};

}  // namespace

std::string gnuplot_script(const Chart& chart, Ground ground) { return Script(chart, ground).write(); }

}  // namespace ballpit
