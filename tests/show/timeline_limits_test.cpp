// SPDX-License-Identifier: MIT
// Where a timeline begins and ends, how much memory it takes, and what it does when a run fails.
#include <string>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "show/session.h"
#include "tests/support/timeline_run.h"

using namespace ballpit;

TEST_CASE("steps before the first and after the furthest are not to be had, the nearest are") {
  Run run(crowd(2, 4, {"impulse"}), settings_of({"impulse"}));
  CHECK(run.timeline.furthest() == 0);
  CHECK(run.timeline.go_to(3));
  CHECK(run.timeline.step_now() == 0);
  run.first_time(20);
  CHECK(run.timeline.go_to(21));
  CHECK(run.timeline.step_now() == 20);
  CHECK(run.timeline.go_to(-1));
  CHECK(run.timeline.step_now() == 0);
  CHECK(run.timeline.furthest() == 20);
  CHECK(run.timeline.time_of(12) == 12 * (1.0 / 480));
}

TEST_CASE("a timeline begins where its world is") {
  const auto world = make_cpu_world(crowd(2, 4, {"impulse"}), settings_of({"impulse"}));
  for (int k = 0; k < 5; ++k) world->step();
  const uint64_t start = world->report().state_hash;
  Timeline timeline(*world, 1.0 / 480, 0);
  for (int k = 0; k < 50; ++k) timeline.step();
  CHECK(timeline.first() == 5);
  CHECK(timeline.go_to(0));
  CHECK(timeline.step_now() == 5);
  CHECK(world->report().state_hash == start);
}

TEST_CASE("snapshots take no more memory than they may, keyframes are thinned, and all steps are within reach") {
  const Kind kind{"kinematic"};
  const int64_t one = make_cpu_world(crowd(2, 4, kind), settings_of(kind))->snapshot()->bytes();
  const int64_t budget = GENERATE_COPY(20 * one, 200 * one);
  Run run(crowd(2, 4, kind), settings_of(kind), budget);
  int64_t most = 0;
  for (int k = 0; k < 1000; ++k) {
    if (k % 100 == 0) run.seen.emplace(k, checkpoint_of(*run.world));
    run.timeline.step();
    REQUIRE(run.timeline.bytes() <= budget);
    most = std::max(most, run.timeline.bytes());
  }
  CHECK(most > 7 * one);
  CHECK(run.timeline.interval() == (budget < 100 * one ? 128 : 16));
  for (const int64_t step : {900, 800, 0, 300, 700, 100}) {
    run.check_from(step, 1);
    CHECK(run.timeline.bytes() <= budget);
  }
}

TEST_CASE("where there is room for no snapshot but the first, all steps are within reach from it") {
  Run run(crowd(2, 4, {"impulse"}), settings_of({"impulse"}), 0);
  const int64_t first = run.timeline.bytes();
  CHECK(first > 0);
  run.first_time(100);
  CHECK(run.timeline.bytes() == first);
  for (const int64_t step : {99, 50, 0}) run.check_from(step, 1);
}

TEST_CASE("on the way back the next steps back are there already") {
  Run run(crowd(2, 4, {"impulse"}), settings_of({"impulse"}));
  run.first_time(300);
  for (const int64_t from : {300, 150}) {  // 150 is behind the recent ones, and remembers what it passes from 144 on
    run.timeline.go_to(from);
    for (int64_t step = from - 1; step > from - 6; --step) {
      CHECK(run.timeline.go_to(step, [] { return true; }));  // without a step
      run.check_now();
    }
  }
}

TEST_CASE("a long way can be gone in parts") {
  Run run(crowd(2, 4, {"impulse"}), settings_of({"impulse"}), 0);
  run.first_time(60);
  int parts = 1;
  for (int left = 20; !run.timeline.go_to(45, [&] { return left-- == 0; }); left = 20) ++parts;
  CHECK(parts == 3);
  CHECK(run.timeline.step_now() == 45);
  run.check_now();
}

TEST_CASE("a run that failed is where it was before, fails again at the same step, and can go back") {
  Scene scene = head_on(10.0, 0.1);
  scene.physics.stiffness = 100;  // far too soft
  Settings settings = settings_of("penalty", 1e-3);
  settings.max_overlap = 0.3;
  const auto stop_of = [](Run& run) -> std::string {
    try {
      for (int k = 0; k < 100; ++k) run.timeline.step();
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  };
  Run run(scene, settings, GENERATE(Timeline::kBudget, int64_t(0)));
  run.first_time(31);
  const std::string message = stop_of(run);
  CHECK_THAT(message, Catch::Contains("step 32 "));
  for (const int64_t back_to : {31, 31, 20, 16, 3, 0}) {
    CHECK(run.timeline.step_now() == 31);
    CHECK(run.timeline.furthest() == 31);
    run.check_now();
    run.check_from(back_to, 0);
    CHECK(stop_of(run) == message);
    CHECK(run.world->last_good_time() == Approx(0.016));
  }
}

TEST_CASE("energy is compared with that of the start, also after going back") {
  Scene scene = wide_box(10);  // a sphere on the floor's spring
  scene.physics.gravity = {0, -10, 0};
  scene.physics.stiffness = 1e4;
  add_sphere(scene, {5, -9.4999, 0}, {0, -0.2, 0}, 0.5);
  Settings settings = settings_of("penalty", 0.019, "explicit-euler");
  settings.max_overlap = 1e6;
  settings.max_energy = 2;
  std::string first;
  for (const bool goes_back : {false, true}) {
    Run run(scene, settings);
    std::string message;
    try {
      for (int k = 0; k < 2000; ++k) {
        run.timeline.step();
        if (goes_back && k % 25 == 24 && run.timeline.step_now() == run.timeline.furthest()) {
          run.timeline.go_to(run.timeline.step_now() / 50 * 40);
        }
      }
    } catch (const RunError& error) {
      message = error.what();
    }
    CHECK_THAT(message, Catch::Contains("--max-energy 2"));
    if (first.empty()) first = message;
    CHECK(message == first);
  }
}

TEST_CASE("a session's world can be gone back in") {
  Session session("bouncing-balls", {});
  Timeline timeline(session.world(), session.settings().dt);
  for (int k = 0; k < 10; ++k) timeline.step();
  const double end = session.world().time();
  CHECK(timeline.time_of(timeline.step_now()) == end);
  timeline.go_to(9);
  CHECK(session.world().time() == timeline.time_of(9));
  CHECK(session.world().time() < end);
}
