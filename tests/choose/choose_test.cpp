// SPDX-License-Identifier: MIT
#include "choose/choose.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "core/error.h"
#include "lab/measure/regret.h"
#include "scene/read_scene.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

const std::string kGas = R"(
[domain]
boundary = "periodic"
[physics]
restitution = 1
[[fill]]
count = 150
radius = 0.05
speed = 1
)";

Choice choice_for(const std::string& text, const std::vector<GivenOption>& given = {}, double budget = 2) {
  const Scene scene = parse_scene(text, "a.toml");
  return choose({scene, given, budget});
}

std::string_view chosen_response(const Choice& choice) {
  REQUIRE(choice.chosen);
  return name_of(choice.chosen->settings.response);
}

/// Whether a rule rules out all variants of a response.
bool is_ruled_out(const Choice& choice, std::string_view method) {
  return std::ranges::find(choice.ruled_out, method, &RuledOut::method) != choice.ruled_out.end();
}

}  // namespace

TEST_CASE("a choice holds in a full run what its pilots promise, and says why") {
  const std::string text = kGas + "[needs]\nduration = 3\nmax_overlap = 0.05\nenergy_tolerance = 0.05\n";
  const Scene scene = parse_scene(text, "a.toml");
  const Choice choice = choose({scene, {}, 2});
  REQUIRE(choice.chosen);
  CHECK(full_run(scene, scene.needs, {}, choice.chosen->settings, 60).holds);
  CHECK(choice.seconds < 3);
  CHECK_THAT(choice.reason, Catch::Contains(choice.chosen->method) && Catch::Contains("cheapest"));
  CHECK_FALSE(choice.unneeded.empty());
  CHECK(choice.pilot_spheres == 150);
  for (const Attempt& attempt : choice.tried) CHECK(attempt.cost > 0);
}

TEST_CASE("effects decide: contact-time takes springs, momentum-order takes exact motion, resting does not") {
  const auto with = [](const std::string& effect) {
    return choice_for(kGas + "[needs]\nduration = 0.5\nmax_overlap = 0.5\neffects = [\"" + effect + "\"]\n");
  };
  CHECK(chosen_response(with("contact-time")) == "penalty");
  CHECK(chosen_response(with("momentum-order")) == "event-driven");
  const Choice resting = with("resting");
  CHECK(chosen_response(resting) != "event-driven");
  CHECK(is_ruled_out(resting, "event-driven"));
}

TEST_CASE("kinematic motion is chosen only where the needs or the options name it") {
  const std::string needs = "[needs]\nduration = 0.5\nmax_overlap = 10\n";
  CHECK(is_ruled_out(choice_for(kGas + needs), "kinematic"));
  CHECK_FALSE(is_ruled_out(choice_for(kGas + needs + "effects = [\"kinematic\"]\n"), "kinematic"));
}

TEST_CASE("options that are given are kept") {
  const std::string text = kGas + "[needs]\nduration = 0.5\nmax_overlap = 0.2\n";
  const Choice choice = choice_for(text, {{"response", "position-based"}, {"precision", "double"}, {"threads", "1"}});
  CHECK(chosen_response(choice) == "position-based");
  CHECK(choice.chosen->settings.precision == Precision::float64);
  CHECK(choice.chosen->settings.threads == 1);
  const Choice fixed = choice_for(text, {{"dt", "0.001"}});
  REQUIRE(fixed.chosen);
  CHECK(fixed.chosen->settings.dt == 0.001);
}

TEST_CASE("paths are compared with exact motion") {
  const Choice choice =
      choice_for(kGas + "[needs]\nduration = 0.5\npath_tolerance = 0.05\n", {{"response", "impulse"}});
  REQUIRE(choice.chosen);
  const Scene scene = parse_scene(kGas + "[needs]\nduration = 0.5\npath_tolerance = 0.05\n", "a.toml");
  const Truth truth = full_truth(scene, scene.needs);
  REQUIRE_FALSE(truth.position.empty());
  CHECK(full_run(scene, scene.needs, truth, choice.chosen->settings, 60).holds);
  // A tenth of the tolerance takes no coarser step.
  const Choice finer =
      choice_for(kGas + "[needs]\nduration = 0.5\npath_tolerance = 0.005\n", {{"response", "impulse"}});
  REQUIRE(finer.chosen);
  CHECK(finer.chosen->settings.dt <= choice.chosen->settings.dt);
  CHECK(finer.chosen->errors[0] <= 0.005);
}

TEST_CASE("without exact motion the truth is a quarter of the step") {
  const Choice choice =
      choice_for(kGas + "[needs]\nduration = 0.3\npath_tolerance = 0.2\neffects = [\"contact-time\"]\n");
  CHECK(chosen_response(choice) == "penalty");
}

TEST_CASE("observables are compared with exact motion") {
  const Choice choice =
      choice_for(kGas + "[needs]\nduration = 5\nmax_overlap = 1\n[needs.observables]\ncollision-rate = 0.2\n");
  REQUIRE(choice.chosen);
  REQUIRE(choice.tolerances.size() == 2);
  CHECK(choice.chosen->errors[1] <= 0.2);
}

TEST_CASE("needs that nothing can meet are reported with the nearest result and its figures") {
  const Choice choice =
      choice_for(kGas + "[needs]\nduration = 1\nenergy_tolerance = 1e-12\neffects = [\"contact-time\"]\n");
  CHECK_FALSE(choice.chosen);
  REQUIRE(choice.nearest);
  CHECK_THAT(choice.reason, Catch::Contains("nothing holds all that is needed; nearest is penalty") &&
                                Catch::Contains("energy_tolerance") && Catch::Contains("allowed 1.00e-12"));
  const Choice contradiction =
      choice_for(kGas + "[needs]\nduration = 1\nmax_overlap = 1\neffects = [\"contact-time\", \"momentum-order\"]\n");
  CHECK_FALSE(contradiction.chosen);
  REQUIRE(contradiction.nearest);
  CHECK(contradiction.ruled_out.size() == variants().size());
  CHECK_THAT(contradiction.reason, Catch::Contains("nothing holds all that is needed; nearest is ") &&
                                       (Catch::Contains("one hit after another") || Catch::Contains("no duration")));
}

TEST_CASE("finer steps that have too little time to come to rest are not excused where a whole pilot has not rested") {
  const std::string gas = kGas + "[needs]\nduration = 1\nmax_speed = 0.001\n";  // it keeps its energy
  for (const double budget : {0.2, 0.4, 0.8}) {
    const Choice choice = choice_for(gas, {{"response", "impulse"}}, budget);
    CAPTURE(budget, choice.tried.size());
    for (const Attempt& attempt : choice.tried) {
      if (attempt.worst > 1) CHECK((!choice.chosen || choice.chosen->method != attempt.method));
    }
  }
}

TEST_CASE("scenes without spheres, of one sphere, of no duration and with overlap have a choice") {
  CHECK(choice_for("[domain]\n[needs]\nduration = 1\nmax_overlap = 0.1\n").chosen);
  const std::string one = "[domain]\n[[spheres]]\nposition = [0.5, 0.5, 0.5]\nradius = 0.1\n";
  CHECK(choice_for(one).chosen);
  CHECK(choice_for(one + "[needs]\nduration = 0\nmax_overlap = 0.1\n").chosen);
  const Choice overlapping = choice_for(one + "[[spheres]]\nposition = [0.55, 0.5, 0.5]\nradius = 0.1\n[physics]\n" +
                                        "initial_overlap = 1\n[needs]\nduration = 3\nmax_overlap = 0.1\n");
  REQUIRE(overlapping.chosen);
  CHECK(is_ruled_out(overlapping, "event-driven"));
}

TEST_CASE("huge and tiny units have a choice") {
  for (const double unit : {1e-9, 1e9}) {
    const std::string text = fmt::format(
        "[domain]\nmax = [{0}, {0}, {0}]\n[physics]\nrestitution = 1\n[[fill]]\ncount = 20\nradius = {1}\nspeed = {0}\n"
        "[needs]\nduration = 2\nmax_overlap = 0.1\n",
        unit, 0.05 * unit);
    INFO(unit);
    CHECK(choice_for(text).chosen);
  }
}

TEST_CASE("dearer settings cost more in their order, and end with finer steps") {
  const Choice choice = choice_for(kGas + "[needs]\nduration = 1\nmax_overlap = 0.1\n", {{"response", "impulse"}});
  REQUIRE(choice.chosen);
  REQUIRE(choice.dearer.size() >= 5);
  CHECK(choice.dearer.back().dt < choice.chosen->settings.dt / 8);
}

TEST_CASE("a run may go on with methods whose pilots were given up only for their cost") {
  // Impulses serve spheres at rest on a floor, and springs need many more steps.
  constexpr int kSide = 60;
  std::string text =
      "[domain]\nmax = [15, 2, 15]\n[physics]\ngravity = [0, -9.81, 0]\nrestitution = 0\n"
      "[needs]\nduration = 2\nmax_overlap = 0.02\n";
  for (int k = 0; k < kSide * kSide; ++k) {
    text += fmt::format("[[spheres]]\nposition = [{}, 0.1, {}]\nradius = 0.1\n", 0.12 + 0.24 * (k % kSide),
                        0.12 + 0.24 * (k / kSide));
  }
  const Choice choice = choice_for(text);
  REQUIRE(choice.chosen);
  int given_up = 0;
  for (const Attempt& attempt : choice.tried) {
    if (attempt.remark != "dearer" || attempt.worst > 1) continue;
    ++given_up;
    INFO(attempt.method);
    CHECK(std::ranges::find(choice.dearer, attempt.settings.response, &Settings::response) != choice.dearer.end());
  }
  CHECK(given_up > 0);
}

TEST_CASE("[needs] that name no observable are wrong input") {
  CHECK_THROWS_AS(choice_for(kGas + "[needs.observables]\nzeal = 1\n"), UserError);
}
