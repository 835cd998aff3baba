// SPDX-License-Identifier: MIT
// What `choose` picks on random scenes, against the cheapest settings of a grid; and what the laboratory makes of it.
#include "lab/experiments/choice.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include "lab/measure/held_out.h"
#include "scene/read_scene.h"

using namespace ballpit;

namespace {

/// A choice that holds.
JudgedScene judged(uint64_t seed, std::string_view family, double cost, double best_cost) {
  JudgedScene scene{seed, {.family = std::string(family), .count = 10}};
  scene.judged.has_choice = scene.judged.has_valid = scene.judged.holds = true;
  scene.judged.cost = cost;
  scene.judged.best_cost = best_cost;
  return scene;
}

JudgedScene broken(uint64_t seed, std::string_view family) {
  JudgedScene scene = judged(seed, family, 0.02, 0.04);
  scene.judged.holds = false;
  return scene;
}

JudgedScene refused(uint64_t seed, std::string_view family, bool has_valid) {
  JudgedScene scene{seed, {.family = std::string(family), .count = 10}};
  scene.judged.has_valid = has_valid;
  return scene;
}

double number_at(const Table& table, size_t row, const std::string& column) {
  const auto found = std::ranges::find(table.columns, column);
  REQUIRE(found != table.columns.end());
  return std::get<double>(table.rows.at(row).at(static_cast<size_t>(found - table.columns.begin())));
}

/// Those drawn as failed.
int failed_in(const Chart& chart) {
  int count = 0;
  for (const Series& series : chart.series) {
    count += static_cast<int>(std::ranges::count_if(series.points, [](const Point& p) { return std::isinf(p.y); }));
  }
  return count;
}

}  // namespace

TEST_CASE("the report counts what is broken and what was missed, and leaves both out of the regrets") {
  const Findings good = choice_findings({judged(1, "gas", 0.02, 0.02), judged(2, "gas", 0.06, 0.02),
                                         judged(3, "heap", 0.009, 0.001), refused(4, "heap", false)});
  CHECK(good.values.at("n") == "4");
  CHECK(good.values.at("failures") == "no tolerance was broken");
  CHECK(good.values.at("median") == "1.00");  // less than 10 ms count as equal
  CHECK(good.values.at("worst") == "3.00");
  for (const Chart& chart : good.charts) CHECK(failed_in(chart) == 0);

  const Findings bad = choice_findings({judged(1, "gas", 0.03, 0.02), broken(2, "gas"), refused(3, "gas", true),
                                        refused(4, "gas", false), broken(5, "planar")});
  CHECK(bad.values.at("failures") == "2 choices broke a tolerance, in 1 nothing was found although something holds");
  CHECK(bad.values.at("worst") == "1.50");
  CHECK(failed_in(bad.charts.at(0)) == 3);
  const Table& families = bad.tables.at(0);
  REQUIRE(families.rows.size() == 3);  // gases, planar, all
  for (const size_t row : {size_t{0}, size_t{2}}) {
    CHECK(number_at(families, row, "broken") == (row == 0 ? 1 : 2));
    CHECK(number_at(families, row, "refused") == 2);
    CHECK(number_at(families, row, "of these, something holds") == 1);
    CHECK(number_at(families, row, "worst regret") == 1.5);
  }
  CHECK(choice_findings({broken(1, "gas")}).values.at("median") == "–");
  CHECK(choice_findings({}).values.at("n") == "0");
}

TEST_CASE("the scenes stand in order of their regret, the broken ones last") {
  const Findings findings = choice_findings(
      {judged(1, "gas", 0.06, 0.02), broken(2, "gas"), judged(3, "heap", 0.03, 0.02), judged(4, "gas", 0.02, 0.02)});
  std::map<double, double> regrets;
  for (const Series& series : findings.charts.at(0).series) {
    if (series.stroke != Stroke::points) continue;
    for (const Point& point : series.points) regrets[point.x] = point.y;
  }
  REQUIRE(regrets.size() == 4);
  CHECK(regrets[12.5] == 1);
  CHECK(regrets[37.5] == Approx(1.5));
  CHECK(regrets[62.5] == Approx(3));
  CHECK(std::isinf(regrets[87.5]));
}

// One scene of each family, and other scenes than those of the laboratory, which begin with seed 1000.
TEST_CASE("on random scenes the choice holds, is found where something holds, and costs at most 4 times the least",
          "[slow]") {
  for (uint64_t seed = 500; seed < 500 + kHeldOutFamilies.size(); ++seed) {
    const HeldOutScene held_out = held_out_scene(seed, drawn_units(seed));
    const Judged judged = judge(held_out.family, parse_scene(held_out.text, "held-out.toml"), 2);
    INFO(held_out.family << ' ' << seed << ": " << judged.method << ' ' << judged.cost << " s, " << judged.best_method
                         << ' ' << judged.best_cost << " s; " << judged.why);
    CHECK(judged.has_choice == judged.has_valid);
    CHECK(judged.holds == judged.has_choice);
    CHECK(judged.regret() <= 4);
  }
}
