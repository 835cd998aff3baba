// SPDX-License-Identifier: MIT
// Charts: equal charts give equal pictures, which show all their parts.
#include "lab/charts/chart.h"

#include <cmath>
#include <regex>

#include <catch2/catch.hpp>

#include "lab/charts/chart_style.h"
#include "lab/charts/gnuplot.h"
#include "lab/report/experiment.h"

using namespace ballpit;
using Catch::Contains;

namespace {

Chart lines() {
  Chart chart{"time", "Ben's time", {"spheres", "", Scale::log}, {"time", "ms", Scale::log}, {}};
  chart.series = {{"linked cell", "linked-cell", {{100, 1, 0.9, 1.2}, {1000, 10}, {10'000, 100}}},
                  {"sorted grid", "sorted-grid", {{100, 1}, {1000, 9}, {10'000, 99}}},
                  {"brute force", "brute-force", {{100, 2}, {1000, 200}, {10'000, INFINITY}}},
                  {"O(n)", "theory", {{100, 0.5}, {10'000, 50}}, Stroke::line}};
  chart.bounds = {{300, "bound"}};
  return chart;
}

Chart map() {
  Chart chart{"map", "Map", {"x", "m"}, {"y", "s"}, {}};
  chart.map = Map{{1, 2, 3}, {10, 20}, {{0, 1, 1}, {1, kNoNumber, INFINITY}}, {{"one", "first"}, {"two", "second"}}};
  return chart;
}

/// The height of a label in the picture.
double height_of(const std::string& script, const std::string& label) {
  std::smatch match;
  const std::regex pattern("set label '[^']*" + label + "' at screen [0-9.]+, screen ([0-9.]+)");
  REQUIRE(std::regex_search(script, match, pattern));
  return std::stod(match[1]);
}

std::vector<std::string> texts_of(const AxisRange& range) {
  std::vector<std::string> texts;
  for (const Tick& tick : ticks_of(range)) texts.push_back(tick.text);
  return texts;
}

}  // namespace

TEST_CASE("a chart's script holds its title, axes with units, and every label") {
  for (const Ground ground : {Ground::light, Ground::dark}) {
    const std::string script = gnuplot_script(lines(), ground);
    for (const char* text : {"Ben''s time", "spheres", "time [ms]", "linked cell", "sorted grid", "brute force", "O(n)",
                             "bound", "logscale x", "logscale y"}) {
      CHECK_THAT(script, Contains(text));
    }
    CHECK_THAT(script, Contains(hex(color_of("linked-cell", ground))));
  }
}

TEST_CASE("labels of lines with nearly equal ends are moved apart, in their order") {
  const std::string script = gnuplot_script(lines(), Ground::light);
  CHECK(height_of(script, "linked cell") - height_of(script, "sorted grid") > 0.04);
  CHECK(height_of(script, "brute force") > height_of(script, "linked cell"));
}

TEST_CASE("a failed run is a cross at the upper edge, spreads are bars") {
  const std::string script = gnuplot_script(lines(), Ground::light);
  const AxisRange y = range_of(lines().y, {0.5, 1, 2, 200, 0.9, 1.2, 9, 10, 50, 99, 100}, true);
  CHECK_THAT(script, Contains("EOD\n10000 " + std::to_string(y.high).substr(0, 5)));
  CHECK_THAT(script, Contains("pointtype 2") && Contains(hex(color_of("failed", Ground::light))));
  CHECK_THAT(script, Contains("100 1 0.9 1.2\n") && Contains("yerrorbars"));
}

TEST_CASE("crosses have one label, beside the last of them") {
  Chart chart = lines();
  chart.series.push_back({"other", "first", {{100, 1}, {1000, INFINITY}}});
  const std::string script = gnuplot_script(chart, Ground::light);
  const size_t first = script.find("'failed'");
  REQUIRE(first != std::string::npos);
  CHECK(script.find("'failed'", first + 1) == std::string::npos);
}

TEST_CASE("cells of a map reach half way to their neighbours and have the colour of their value") {
  const std::string script = gnuplot_script(map(), Ground::light);
  CHECK_THAT(script, Contains("1 10 0.5 1.5 5 15 " + std::to_string(color_of("first", Ground::light))));
  CHECK_THAT(script, Contains("3 20 2.5 3.5 15 25 " + std::to_string(color_of("failed", Ground::light))));
  CHECK_FALSE(Contains("2 20 1.5").match(script));  // not measured
  CHECK_THAT(script, Contains("one") && Contains("two"));
}

TEST_CASE("labels of points are listed beside the plot, in their order, below those of lines") {
  Chart chart = lines();
  chart.lists_points = true;
  chart.series.insert(chart.series.end(), {{"upper", "first", {{100, 1}}, Stroke::points},
                                           {"none", "second", {}, Stroke::points},
                                           {"lower", "third", {{10'000, 100}}, Stroke::points}});
  const std::string script = gnuplot_script(chart, Ground::light);
  CHECK(height_of(script, "upper") > height_of(script, "lower") + 0.04);
  CHECK(height_of(script, "upper") < height_of(script, "linked cell"));
  CHECK_THAT(script, !Contains("none"));
  CHECK_THAT(script, Contains("△ upper' at screen 0.739,") && Contains("□ lower' at screen 0.739,"));
}

TEST_CASE("an unknown role is a bug") { CHECK_THROWS_AS(style_of("nonsense"), std::logic_error); }

TEST_CASE("labels are readable on both backgrounds: every role has a contrast of at least 4") {
  const auto channel = [](Rgb color, int shift) {
    const double c = (color >> shift & 255u) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const auto light = [&](Rgb c) { return 0.2126 * channel(c, 16) + 0.7152 * channel(c, 8) + 0.0722 * channel(c, 0); };
  for (const Ground ground : {Ground::light, Ground::dark}) {
    for (const char* role : {"brute-force", "sort-and-sweep", "linked-cell", "sorted-grid", "penalty", "second",
                             "fourth", "fifth", "theory", "failed", "impulse"}) {
      const double a = light(text_color_of(role, ground)), b = light(ground_style(ground).background);
      CHECK((std::max(a, b) + 0.05) / (std::min(a, b) + 0.05) >= 4);
    }
  }
}

TEST_CASE("ticks are round numbers") {
  CHECK(texts_of({100, 1e6, Scale::log}) == std::vector<std::string>{"100", "1000", "10\u2009000", "10⁵", "10⁶"});
  CHECK(texts_of({0.001, 0.1, Scale::log}) ==
        std::vector<std::string>{"0.001", "0.002", "0.005", "0.01", "0.02", "0.05", "0.1"});
  CHECK(texts_of({1e-7, 1e-4, Scale::log}) == std::vector<std::string>{"10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴"});
  CHECK(texts_of({0, 100, Scale::linear}) == std::vector<std::string>{"0", "20", "40", "60", "80", "100"});
  CHECK(texts_of({-0.1, 0.2, Scale::linear}) ==
        std::vector<std::string>{"-0.1", "-0.05", "0", "0.05", "0.1", "0.15", "0.2"});
}

TEST_CASE("gnuplot draws the same chart to the same bytes, with no fonts inside") {
  REQUIRE_FALSE(gnuplot_path().empty());
  for (const Chart& chart : {lines(), map()}) {
    for (const Ground ground : {Ground::light, Ground::dark}) {
      const std::string svg = draw_svg(chart, ground, gnuplot_path());
      CHECK(svg == draw_svg(chart, ground, gnuplot_path()));
      CHECK_THAT(svg, Contains("</svg>") && Contains("sans-serif") && !Contains("font-face"));
      CHECK_THAT(svg, Contains("<title>" + std::string(chart.name == "map" ? "Map" : "Ben's time") + "</title>"));
    }
  }
}

TEST_CASE("a failure of gnuplot is an error with its message") {
  Chart broken = lines();
  broken.x.low = broken.x.high = 0;  // on a logarithmic axis
  CHECK_THROWS_WITH(draw_svg(broken, Ground::light, gnuplot_path()), Contains("failed on chart time"));
}
