// SPDX-License-Identifier: MIT
// The exact ghost of a demonstration: dropped, hidden, kept and renewed.
#include <filesystem>

#include <catch2/catch.hpp>

#include "show/demo.h"
#include "show/film.h"
#include "tests/show/key_named.h"

using namespace ballpit;

namespace {

GhostInspection ghost_of(Demo& demo) {
  const std::optional<GhostInspection>& ghost = demo.inspection().ghost;
  REQUIRE(ghost);
  return *ghost;
}

void play(Demo& demo, int steps) {
  for (int k = 0; k < steps; ++k) demo.step();
}

const std::vector<GivenOption> kImpulse{{"threads", "1"}, {"response", "impulse"}};

}  // namespace

TEST_CASE("a key drops the ghost here, and another one hides it and shows it again") {
  Demo demo("gas-dense", kImpulse);
  play(demo, 5);
  CHECK_FALSE(demo.inspection().ghost);
  demo.perform(key_named("E"));
  CHECK(demo.view.shows("ghost"));
  CHECK(ghost_of(demo).dropped == demo.session.time());
  CHECK(ghost_of(demo).curve.back().largest == 0);
  play(demo, 10);
  const GhostInspection seen = ghost_of(demo);
  CHECK(seen.curve.size() == 11);
  CHECK(seen.curve.back().largest > 0.01);
  demo.perform(key_named("X"));
  CHECK_FALSE(demo.view.shows("ghost"));
  demo.perform(key_named("X"));
  CHECK(ghost_of(demo).dropped == seen.dropped);
  CHECK(ghost_of(demo).ahead == seen.ahead);
  play(demo, 3);
  demo.perform(key_named("E"));  // anew
  CHECK(ghost_of(demo).dropped == demo.session.time());
  CHECK(ghost_of(demo).curve.size() == 1);
}

TEST_CASE("the ghost is where it was at each moment of the timeline, and knows the first wrong collision") {
  Demo demo("gas-dense", kImpulse);
  demo.perform(key_named("E"));
  std::vector<GhostInspection> seen{ghost_of(demo)};
  for (int k = 1; k <= 40; ++k) {
    demo.step();
    seen.push_back(ghost_of(demo));
  }
  REQUIRE(seen.back().wrong);
  for (const int k : {20, 3, 39, 0, 40}) {
    demo.go_to(k);
    INFO("step " << k);
    CHECK(ghost_of(demo).ahead == seen[size_t(k)].ahead);
    CHECK(ghost_of(demo).curve.back().median == seen[size_t(k)].curve.back().median);
  }
}

TEST_CASE("a ghost dropped in the past sees each step of the known future") {
  Demo demo("gas-dense", kImpulse);
  play(demo, 40);
  demo.go_to(0);
  demo.perform(key_named("E"));
  demo.go_to(40);
  const GhostInspection jumped = ghost_of(demo);
  Demo stepped("gas-dense", kImpulse);
  stepped.perform(key_named("E"));
  play(stepped, 40);
  CHECK(jumped.curve.size() == ghost_of(stepped).curve.size());
  CHECK(jumped.ahead == ghost_of(stepped).ahead);
  REQUIRE(jumped.wrong);
  CHECK(jumped.wrong->time == ghost_of(stepped).wrong->time);
}

TEST_CASE("the search for the first wrong collision goes on after a look at the past") {
  const std::vector<GivenOption> given{{"threads", "1"}, {"swept", "on"}, {"precision", "double"}};
  Demo demo("lecture-grid", given), straight("lecture-grid", given);
  for (Demo* each : {&demo, &straight}) {
    each->perform(key_named("E"));
    play(*each, 400);  // collisions, all on time
    CHECK_FALSE(ghost_of(*each).wrong);
  }
  demo.go_to(100);
  CHECK(ghost_of(demo).curve.back().time == demo.session.time());
  demo.go_to(400);
  play(demo, 1);
  play(straight, 1);
  CHECK_FALSE(ghost_of(demo).wrong);
  play(demo, 2000);
  play(straight, 2000);
  CHECK(ghost_of(demo).wrong.has_value() == ghost_of(straight).wrong.has_value());
  CHECK(ghost_of(demo).ahead == ghost_of(straight).ahead);
}

TEST_CASE("other settings keep the ghost, another scene, a restart or other collisions drop it anew") {
  Demo demo("gas-dense", kImpulse);
  demo.perform(key_named("E"));
  play(demo, 10);
  const auto dropped = [&] { return ghost_of(demo).dropped; };
  for (const auto& [option, value] : {std::pair{"dt", "0.002"}, {"response", "kinematic"}, {"broadphase", "auto"}}) {
    demo.set(option, value);
    CHECK(dropped() == 0);
    play(demo, 3);
  }
  CHECK(ghost_of(demo).curve.size() == 20);
  Physics physics = demo.session.scene().physics;
  physics.stiffness *= 2;  // not of hard spheres
  demo.set_physics(physics);
  CHECK(dropped() == 0);
  physics.restitution = 0.5;
  demo.set_physics(physics);
  CHECK(dropped() == demo.session.time());
  play(demo, 3);
  demo.restart();
  CHECK(dropped() == 0);
  CHECK(ghost_of(demo).curve.size() == 1);
  play(demo, 3);
  demo.set("count", "100");
  CHECK(ghost_of(demo).ahead.size() == 100);
  demo.load("two-spheres");
  CHECK(ghost_of(demo).ahead.size() == 2);
}

TEST_CASE("back at its start, a ghost compares other settings from there") {
  Demo demo("two-spheres", {{"threads", "1"}});
  demo.perform(key_named("E"));
  play(demo, 300);
  REQUIRE(ghost_of(demo).wrong);
  demo.go_to(0);
  demo.set("swept", "on");
  play(demo, 300);
  CHECK_FALSE(ghost_of(demo).is_unwatched);
  CHECK_FALSE(ghost_of(demo).wrong);
}

TEST_CASE("event-driven motion says that it is exact itself") {
  Demo demo("gas-dense", {{"threads", "1"}});
  demo.perform(key_named("E"));
  play(demo, 20);
  CHECK(ghost_of(demo).is_exact);
  CHECK(ghost_of(demo).curve.back().largest == 0);
  demo.set("response", "impulse");
  CHECK_FALSE(ghost_of(demo).is_exact);
}

TEST_CASE("a film has a ghost from its start, also where its first frame is later") {
  Demo demo("gas-dense", kImpulse);
  demo.view.overlays = {"ghost"};
  demo.touch();
  FilmPlan plan;
  plan.folder = "ghost_film";
  plan.frames = 1;
  plan.from = 0.05;
  Film film(demo, plan);
  CHECK(film.advance([] { return false; }));
  const GhostInspection seen = ghost_of(demo);
  CHECK(seen.dropped == 0);
  CHECK(seen.curve.size() == 13);
  CHECK(seen.wrong);
  film.finish();
  std::filesystem::remove_all(plan.folder);
}
