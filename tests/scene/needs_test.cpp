// SPDX-License-Identifier: MIT
// [needs] of a scene file, and the reason for its [defaults].
#include <catch2/catch.hpp>

#include "scene/read_scene.h"

using namespace ballpit;

namespace {

Needs needs_in(const std::string& text) { return parse_scene(text, "a.toml").needs; }

void check_error(const std::string& text, const std::string& message) {
  INFO(text);
  CHECK_THROWS_WITH(parse_scene(text, "a.toml"), "a.toml:" + message);
}

}  // namespace

TEST_CASE("a scene says what it needs: figures, effects, paths, observables") {
  const Needs needs = needs_in(
      "[needs]\nmax_overlap_ever = 0.2\neffects = [\"resting\", \"contact-time\", \"resting\"]\npath_tolerance = 0.5\n"
      "[needs.observables]\ncompressibility = 0.01\npressure = 2\n");
  CHECK(needs.are_declared);
  CHECK(needs.max_overlap_ever == 0.2);
  CHECK(needs.path_tolerance == 0.5);
  CHECK(needs.has(Effect::resting));
  CHECK(needs.has(Effect::contact_time));
  CHECK(needs.has(Effect::paths));  // a tolerance asks for them
  CHECK_FALSE(needs.has(Effect::momentum_order));
  CHECK(needs.effects.size() == 3);
  REQUIRE(needs.observables.size() == 2);
  CHECK(needs.observables[0].name == "compressibility");
  CHECK(needs.observables[0].tolerance == 0.01);
  CHECK(needs.observables[0].where == "a.toml:6: [needs.observables] compressibility");
}

TEST_CASE("a scene without [needs] declares none") {
  CHECK_FALSE(needs_in("[domain]\n").are_declared);
  CHECK(needs_in("[domain]\n").effects.empty());
  CHECK(needs_in("[needs]\n").are_declared);
}

TEST_CASE("needs that are not allowed are refused with their place") {
  check_error("[needs]\neffects = \"resting\"",
              "2: [needs] effects: found \"resting\", allowed an array of texts: some of "
              "resting, contact-time, paths, momentum-order, kinematic");
  check_error(
      "[needs]\neffects = [\"friction\"]",
      "2: [needs] effects: found \"friction\", allowed resting, contact-time, paths, momentum-order, kinematic");
  check_error("[needs]\neffects = [1]",
              "2: [needs] effects: found 1, allowed resting, contact-time, paths, momentum-order, kinematic");
  check_error("[needs]\npath_tolerance = -1", "2: [needs] path_tolerance: found -1, allowed 0 to 1e+15");
  check_error("[needs]\nmax_overlap_ever = nan", "2: [needs] max_overlap_ever: found nan, allowed 0 to 1e+15");
  check_error("[needs]\nobservables = 1", "2: [needs] observables: found 1, allowed a table [needs.observables]");
  check_error("[needs.observables]\npressure = \"low\"",
              "2: [needs.observables] pressure: found \"low\", allowed a number, 0 to 1e+15");
}

TEST_CASE("a scene may say why it has its defaults") {
  const Scene scene = parse_scene("[defaults]\ndt = 0.1\nbecause = \"it shows penalty springs\"", "a.toml");
  CHECK(scene.because == "it shows penalty springs");
  REQUIRE(scene.defaults.size() == 1);
  CHECK(scene.defaults[0].key == "dt");
  CHECK(parse_scene("[defaults]\ndt = 0.1", "a.toml").because.empty());
  check_error("[defaults]\nbecause = 1", "2: [defaults] because: found 1, allowed a text in quotes");
}

TEST_CASE("a scene says what fills its picture, or nothing does but the domain") {
  CHECK_FALSE(parse_scene("[domain]\nmax = [2, 2, 2]\n", "a.toml").view);
  const auto view = parse_scene("[domain]\nmax = [2, 2, 2]\n[view]\nmax = [1, 3, 1]\n", "a.toml").view;
  REQUIRE(view);
  CHECK(view->min == Vec3d(0));
  CHECK(view->max == Vec3d(1, 3, 1));
  CHECK_THROWS_WITH(parse_scene("[domain]\n[view]\nmin = [0, 1, 0]\n", "a.toml"),
                    "a.toml:3: [view] min: found 1 to 1 at [1], allowed min below max");
}
