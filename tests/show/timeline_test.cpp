// SPDX-License-Identifier: MIT
// Going back and forward again: by every response, to the same bits.
#include <catch2/catch.hpp>

#include "show/session.h"
#include "tests/support/timeline_run.h"

using namespace ballpit;

TEST_CASE("with every response, in both precisions, an earlier state is restored bit-identically, and continues so") {
  int turn = 0;
  for (const Kind& kind : kinds()) {
    for (const char* const precision : {"float", "double"}) {
      for (const double skin : {0.0, 0.1}) {
        const int dimensions = 2 + turn % 2;
        const Boundary boundary = turn / 2 % 2 == 0 ? Boundary::walls : Boundary::periodic;
        const Scene scene = crowd(dimensions, dimensions == 2 ? 8 : 4, kind, boundary);
        Settings settings = settings_of(kind, turn++);
        settings.precision = named<Precision>(precision);
        settings.skin = skin;
        INFO(kind << ", " << precision << ", skin " << skin << ", " << name_of(settings.broadphase));
        for (const int64_t budget : {Timeline::kBudget, int64_t(0)}) {  // each step is kept, or none but the first
          Run run(scene, settings, budget);
          run.first_time(40);
          CHECK(run.seen.at(40).collisions > 0);
          for (const int64_t step : {39, 38, 17, 0, 16, 40, 1}) run.check_from(step, step == 0 ? 40 : 3);
        }
      }
    }
  }
}

TEST_CASE("so many spheres that they are sorted in memory are there again in their order") {
  // Sorted before steps 1 and 65. Between, positions and velocities alone would not do: forces are summed in their
  // order.
  int turn = 0;
  for (const Kind& kind : keepers()) {
    const Scene scene = crowd(2, 65, kind);
    REQUIRE(scene.bodies.size() >= 4096);
    Settings settings = settings_of(kind, turn);
    settings.broadphase = BroadPhase::sorted_grid;
    settings.precision = named<Precision>(turn % 2 == 0 ? "float" : "double");
    settings.skin = turn++ % 3 * 0.05;
    Run run(scene, settings, turn % 2 == 0 ? Timeline::kBudget : 2'000'000);
    run.first_time(72, {0, 1, 40, 60, 64, 65, 70, 72});
    INFO(kind << ", " << name_of(settings.precision) << ", bytes " << run.timeline.bytes());
    for (const int64_t step : {70, 58, 63, 39, 0}) run.check_from(step, step == 58 ? 14 : 2);
  }
}

TEST_CASE("what is ahead is stepped on as if nobody had gone back") {
  for (const Kind& kind : keepers()) {
    const Scene scene = crowd(3, 4, kind);
    Run back(scene, settings_of(kind), 30'000), ahead(scene, settings_of(kind));
    for (int k = 0; k < 30; ++k) back.timeline.step();
    for (const int64_t step : {3, 25, 8}) back.timeline.go_to(step);
    while (back.timeline.step_now() < 80) back.timeline.step();
    ahead.first_time(80);
    INFO(kind);
    CHECK(back.timeline.furthest() == 80);
    CHECK(checkpoint_of(*back.world) == ahead.seen.at(80));
  }
}

TEST_CASE("the speed that is reached is that of the last half second, and 0 while paused") {
  Session session("lecture-grid", {{"threads", "1"}});
  Timeline timeline(session.world(), session.settings().dt);
  Player player;
  player.speed = 2;
  const auto play = [&](double share) {
    for (int k = 0; k < 12; ++k) {
      player.observe(0.1);
      player.advance(timeline, 0.1, share);
    }
    return player.reached();
  };
  CHECK(play(60) == Approx(2).epsilon(0.05));
  CHECK(play(0) == Approx(session.settings().dt / 0.1).epsilon(0.05));  // a step for each frame
  player.is_running = false;
  CHECK(player.reached() == 0);
}
