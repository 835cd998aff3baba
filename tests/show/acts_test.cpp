// SPDX-License-Identifier: MIT
// Acts on a demonstration: going back over them and forward again, and what else goes on sensibly after them.
#include <array>
#include <map>

#include <catch2/catch.hpp>

#include "show/demo.h"
#include "tests/support/kinds.h"

using namespace ballpit;

namespace {

constexpr std::array kLecture{"lecture-grid", "lecture-periodic"};

Act toss(int64_t sphere, const Vec3d& velocity) { return {.sphere = sphere, .vector = velocity}; }
Act drop(const Vec3d& place) { return {.kind = ActKind::drop, .vector = place, .radius = 0.05, .mass = 1}; }

/// Steps, and notes the state at each.
void play(Demo& demo, int steps, std::map<int64_t, uint64_t>& seen) {
  for (int k = 0; k < steps; ++k) {
    demo.step();
    seen[demo.timeline->step_now()] = demo.report().state_hash;
  }
}

}  // namespace

TEST_CASE("steps over acts are restored and computed again with the same bits, by every response") {
  for (const Kind& kind : kinds()) {
    for (const int64_t budget : {Timeline::kBudget, int64_t(0)}) {  // each step is kept, or none but the first
      Scene scene = crowd(3, 4, kind);
      scene.domain.max.y += 0.3;
      const Settings settings = settings_of(kind);
      const auto world = make_cpu_world(scene, settings);
      Acts acts(scene.domain);
      acts.steps_by(settings.dt);
      Timeline timeline(*world, settings.dt, budget, &acts);
      std::map<int64_t, uint64_t> seen{};
      const auto step = [&] {
        timeline.step();
        seen[timeline.step_now()] = world->report().state_hash;
      };
      const auto act = [&](const Act& what) {
        timeline.act(what);
        seen[timeline.step_now()] = world->report().state_hash;
      };
      act(toss(0, {0, 1, 0}));  // at the first step
      for (int k = 0; k < 10; ++k) step();
      act(toss(3, {1, 2, 0.5}));
      for (int k = 0; k < 6; ++k) step();
      act(drop({0.2, scene.domain.max.y - 0.1, 0.2}));
      act({.kind = ActKind::push, .sphere = 64, .vector = {0, -1, 0}, .reach = 0.4});
      for (int k = 0; k < 14; ++k) step();
      INFO(kind);
      for (const int64_t goal : {29, 16, 15, 30, 0, 11, 10, 9, 30}) {
        timeline.go_to(goal);
        CHECK(world->report().state_hash == (goal == 0 ? seen[0] : seen.at(goal)));
        CHECK(world->shape().count == (goal >= 16 ? 65 : 64));
      }
      CHECK(timeline.furthest() == 30);
    }
  }
}

TEST_CASE("another act at an earlier step forgets what was ahead, the acts too") {
  Demo demo("lecture-grid", {{"threads", "1"}});
  std::map<int64_t, uint64_t> first, second, plain;
  play(demo, 5, first);
  demo.act(toss(2, {1, 1, 0}));
  play(demo, 5, first);
  demo.act(toss(4, {-1, 0, 0}));
  play(demo, 5, first);
  demo.go_to(8);
  CHECK(demo.report().state_hash == first.at(8));
  demo.act(toss(7, {0, 2, 0}));
  CHECK(demo.timeline->furthest() == 8);
  CHECK(demo.session.acts().all().size() == 2);
  CHECK(demo.report().state_hash != first.at(8));
  play(demo, 7, second);
  CHECK(second.at(15) != first.at(15));

  // The same acts from a list.
  Demo again("lecture-grid", {{"threads", "2"}, {"broadphase", "brute-force"}});
  again.play(demo.session.acts().all());
  play(again, 15, plain);
  CHECK(plain.at(15) == second.at(15));
  CHECK(plain.at(5) != first.at(5));  // the state of the step of an act has it
}

TEST_CASE("a refused act changes nothing, and says why") {
  for (const char* const scene : kLecture) {
    Demo demo(scene, {{"threads", "1"}});
    std::map<int64_t, uint64_t> seen;
    play(demo, 5, seen);
    demo.act(toss(1, {0.5, 0, 0}));
    play(demo, 5, seen);
    demo.go_to(7);
    demo.act(drop(demo.session.world().bodies().position[3]));
    CHECK_THAT(demo.message(), Catch::Contains("no room for a sphere of radius 0.05 m"));
    CHECK(demo.session.acts().all().size() == 1);
    CHECK(demo.timeline->furthest() == 10);
    CHECK(demo.report().state_hash == seen.at(7));
    demo.go_to(10);
    CHECK(demo.report().state_hash == seen.at(10));
    demo.act(toss(99, {1, 0, 0}));
    CHECK_THAT(demo.message(), Catch::Contains("there is no sphere 99"));
  }
}

TEST_CASE("the drift of the energy counts from the last act, also after going back") {
  Demo demo("lecture-grid", {{"threads", "1"}});
  const auto drift = [&] {
    demo.report();
    return demo.history().back().energy_drift;
  };
  for (int k = 0; k < 5; ++k) demo.step();
  const float before = drift();
  demo.act(toss(2, {20, 0, 0}));
  CHECK(drift() == 0);
  demo.step();
  CHECK(std::fabs(drift()) < 0.5f);
  demo.go_to(4);
  CHECK(std::fabs(drift() - before) < 0.1f);
  demo.go_to(6);
  CHECK(std::fabs(drift()) < 0.5f);
  demo.set("response", "kinematic");  // a world of its own, with a start of its own
  CHECK(drift() == 0);
}

TEST_CASE("the ghost begins anew after an act, on the way forward and back") {
  Demo demo("lecture-grid", {{"threads", "1"}});
  demo.drop_ghost();
  const auto dropped = [&] { return demo.inspection().ghost->dropped; };
  for (int k = 0; k < 5; ++k) demo.step();
  CHECK(dropped() == 0);
  demo.act(toss(2, {1, 0, 0}));
  const double acted_at = demo.session.time();
  CHECK(dropped() == acted_at);
  for (int k = 0; k < 5; ++k) demo.step();
  CHECK(dropped() == acted_at);
  demo.go_to(3);
  CHECK(dropped() == demo.session.time());
  demo.go_to(9);
  CHECK(dropped() == acted_at);
}

TEST_CASE("a picked sphere that is not yet there is picked no more") {
  Demo demo("lecture-grid", {{"threads", "1"}});
  demo.step();
  demo.act(drop({2.55, 3.4, 0}));
  REQUIRE(demo.message().empty());
  demo.view.selected = 20;
  CHECK(demo.inspection().bodies.count == 21);
  CHECK(demo.view.selected == 20);
  demo.go_to(0);
  CHECK(demo.inspection().bodies.count == 20);
  CHECK(demo.view.selected == -1);
}

TEST_CASE("a restart repeats the acts of the file and drops those of the hand, another count drops all") {
  Demo demo("rain", {{"threads", "1"}, {"count", "50"}});
  demo.play({{.time = 0, .sphere = 1, .vector = {0, 1, 0}}});
  demo.step();
  demo.act(toss(2, {0, 1, 0}));
  CHECK(demo.session.acts().all().size() == 2);
  demo.restart();
  CHECK(demo.session.acts().all().size() == 1);
  CHECK(demo.session.world().bodies().velocity[1].y == 1);
  demo.set("count", "30");
  CHECK(demo.session.acts().all().empty());
  demo.load("two-spheres");
  CHECK(demo.session.acts().all().empty());
}

TEST_CASE("a run that failed goes on after another act") {
  Demo demo("lecture-grid", {{"threads", "1"}});
  demo.act(toss(0, {0, 1e4, 0}));
  for (int k = 0; k < 40 && demo.player.failure().empty(); ++k) demo.step();
  CHECK_FALSE(demo.player.failure().empty());
  demo.act(toss(0, {0, 1, 0}));
  CHECK(demo.player.failure().empty());
  for (int k = 0; k < 20; ++k) demo.step();
  CHECK(demo.player.failure().empty());
}

TEST_CASE("settings may change between acts, acts to come stay where they are in time") {
  Demo demo("lecture-grid", {{"threads", "1"}, {"dt", "0.01"}});
  demo.play({{.time = 0.055, .sphere = 0, .vector = {3, 0, 0}}, {.time = 0.1, .sphere = 1, .vector = {4, 0, 0}}});
  CHECK_FALSE(demo.session.changed_at());
  for (int k = 0; k < 6; ++k) demo.step();
  CHECK(demo.session.world().bodies().velocity[0].x == 3);
  demo.set("response", "kinematic");
  demo.set("dt", "0.02");
  CHECK(demo.session.changed_at() == demo.session.time());
  CHECK(demo.session.world().bodies().velocity[1].x != 4);
  for (int k = 0; k < 2; ++k) demo.step();
  CHECK(demo.session.time() == Approx(0.1));
  CHECK(demo.session.world().bodies().velocity[1].x == 4);
}

TEST_CASE("with --response auto, an act ends the watch, and the run goes on") {
  Session session("two-spheres", {{"response", "auto"}, {"threads", "1"}});
  session.play({{.time = 0.5, .sphere = 0, .vector = {0, 30, 0}}});
  session.advance_to(1, [] { return false; });
  CHECK(session.steps_up().empty());
  CHECK(session.time() == Approx(1).epsilon(0.01));
}
