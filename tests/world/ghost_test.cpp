// SPDX-License-Identifier: MIT
// The exact ghost: how far a stepped world is from exact motion.
#include "world/ghost.h"

#include <ctime>

#include <catch2/catch.hpp>

#include "tests/support/hard_sphere_gas.h"
#include "tests/support/haunted.h"

using namespace ballpit;

namespace {

/// [s] of the processor for this thread, whatever runs beside it.
[[maybe_unused]] double spent() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

}  // namespace

TEST_CASE("from the same state, event-driven motion and its ghost have no distance, and no collision is wrong") {
  for (const int dimensions : {2, 3}) {
    for (const Boundary boundary : {Boundary::walls, Boundary::open_top, Boundary::periodic}) {
      const Scene scene = make_crowd(dimensions, 4, boundary, 1, 0.04, 0.055);
      const double dt = dimensions == 2 ? 0.01 : 0.1;  // and then several collisions of a sphere in a step
      Haunted haunted(scene, stepping("event-driven", dt));
      const GhostInspection seen = haunted.step(50);
      INFO(dimensions << ", boundary " << int(boundary) << ", lack " << seen.lack);
      CHECK(haunted.world->report().tally.collisions > 20);
      REQUIRE(seen.curve.size() > 32);
      CHECK(seen.curve.back().largest == 0);
      CHECK_FALSE(seen.wrong);
      CHECK(seen.ahead.size() == scene.bodies.position.size());
    }
  }
}

TEST_CASE("distances are those to the nearest image, in radii") {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(1.0), Boundary::periodic, 3};
  add_sphere(scene, {0.9, 0.5, 0.5}, {1, 0, 0}, 0.1);
  GhostInspection seen;
  {
    Haunted slow(scene, stepping("impulse", 0.06));
    scene.bodies.velocity[0].x = 2;
    const auto fast = make_cpu_world(scene, stepping("impulse", 0.06));
    scene.bodies.velocity[0].x = 1;
    fast->step();  // at 0.02, beyond the border; the ghost at 0.96
    seen = slow.ghost.inspect(*fast, 0.06, 0.06, false);
    CHECK(seen.ahead[0].x == Approx(-0.06));
  }
  Haunted haunted(scene, stepping("impulse", 0.15));
  scene.bodies.velocity[0].x = 2;
  const auto faster = make_cpu_world(scene, stepping("impulse", 0.15));
  faster->step();  // at x = 0.2; the ghost at 0.05
  seen = haunted.ghost.inspect(*faster, 0.15, 0.15, false);
  CHECK(seen.curve.back().largest == Approx(1.5));
  REQUIRE(seen.ahead.size() == 1);
  CHECK(seen.ahead[0].x == Approx(-0.15));
  faster->step();
  faster->step();  // at 0.8; the ghost at 0.35
  faster->step();  // at 0.1; the ghost at 0.5
  seen = haunted.ghost.inspect(*faster, 0.6, 0.15, false);
  CHECK(seen.ahead[0].x == Approx(0.4));
}

TEST_CASE("stepping back gives the same distances again, and what was seen is remembered") {
  Scene scene = melted_gas(3, 0.5, 1);
  Haunted haunted(scene, stepping("impulse", 0.01));
  std::vector<std::unique_ptr<Snapshot>> states;
  std::vector<GhostInspection> seen;
  for (int k = 0; k <= 60; ++k) {
    states.push_back(haunted.world->snapshot());
    seen.push_back(haunted.now());
    haunted.step(1);
  }
  for (const int k : {30, 29, 2, 59, 0, 17}) {
    haunted.world->restore(*states[size_t(k)]);
    const GhostInspection again = haunted.now();
    INFO("step " << k);
    CHECK(again.ahead == seen[size_t(k)].ahead);
    REQUIRE(again.curve.size() == seen[size_t(k)].curve.size());
    CHECK(again.curve.back().median == seen[size_t(k)].curve.back().median);
    CHECK(again.wrong.has_value() == seen[size_t(k)].wrong.has_value());
  }
}

TEST_CASE("after a change of the settings the ghost goes on, and its curve up to there stays") {
  const Scene scene = melted_gas(3, 0.3, 1);
  Haunted haunted(scene, stepping("impulse", 0.01));
  const double then = haunted.step(20).curve.back().median;
  haunted.ghost.forget_after(0.1);
  CHECK(haunted.ghost.seen() == 0.1);
  haunted.world->restore(*haunted.world->snapshot());
  const GhostInspection seen = haunted.now();
  CHECK(seen.curve.size() == 12);  // 0 to 0.1 s, and now
  CHECK(seen.curve.back().median == then);
  CHECK(seen.is_unwatched);
}

TEST_CASE("the curve has no more than its samples, however long it is, and ends at the present") {
  Haunted haunted(meeting(), stepping("impulse", 1e-3, true));
  for (int k = 0; k < 10; ++k) {
    const GhostInspection seen = haunted.step(300);
    CHECK(seen.curve.size() <= Ghost::kMaxSamples + 1);
    CHECK(seen.curve.size() > Ghost::kMaxSamples / 3);
    CHECK(seen.curve.back().time == Approx(0.3 * (k + 1)));
    for (size_t i = 1; i < seen.curve.size(); ++i) REQUIRE(seen.curve[i].time > seen.curve[i - 1].time);
  }
}

TEST_CASE("exact motion refuses a state of deep overlap, and ends where collisions never end") {
  Scene scene = wide_box(2);
  scene.physics.initial_overlap = 1;
  add_sphere(scene, {0, 0, 0}, Vec3d(0.0), 0.5);
  add_sphere(scene, {0.6, 0, 0}, Vec3d(0.0), 0.5);  // 80 % of a radius
  GhostInspection seen = Haunted(scene, stepping("impulse", 0.01)).now();
  CHECK_THAT(std::string(seen.lack), Catch::Contains("overlap by more than half a radius"));
  CHECK(seen.ahead.empty());

  Scene stack;
  stack.physics.gravity = {0, -10, 0};
  stack.physics.restitution = stack.physics.wall_restitution = 0.3;
  for (const double y : {0.1, 0.3, 0.5}) add_sphere(stack, {0.5, y, 0.5}, Vec3d(0.0), 0.1);
  Haunted haunted(stack, stepping("impulse", 0.01));
  const auto start = haunted.world->snapshot();
  const auto then = haunted.now().ahead;
  seen = haunted.step(20);
  CHECK_THAT(std::string(seen.lack), Catch::Contains("collisions never end"));
  CHECK(seen.ahead.empty());
  haunted.world->restore(*start);  // before that, exact motion is there
  CHECK(haunted.now().lack.empty());
  CHECK(haunted.now().ahead == then);
}

TEST_CASE("rounding grows by Lyapunov's exponent, whose e-folds for each collision are those in the table") {
  for (const auto& [density, dt] : {std::pair{0.1, 0.1}, {0.5, 0.02}}) {
    const Scene scene = melted_gas(5, density, 3);
    const Settings settings = event_driven_gas(dt);
    const auto world = make_cpu_world(scene, settings);
    for (int k = 0; k < 20; ++k) world->step();
    Ghost ghost(scene, settings, *world, 20 * dt);
    std::vector<GhostDistance> grown;  // where it is far from rounding and from the size of a sphere
    double growth = 0;
    for (int k = 21; k < 600; ++k) {
      world->step();
      ghost.follow(*world, k * dt, dt);
      const GhostInspection seen = ghost.inspect(*world, k * dt, dt, true);
      if (seen.curve.back().median > 1e-4) break;
      if (seen.curve.back().median > 1e-12) grown.push_back(seen.curve.back());
      growth = seen.growth;
      if (seen.curve.back().largest < 1e-6) CHECK_FALSE(seen.wrong);
    }
    REQUIRE(grown.size() > 10);
    const double measured =
        std::log(grown.back().median / grown.front().median) / (grown.back().time - grown.front().time);
    INFO("density " << density);
    CHECK(growth > 0);
    CHECK(measured == Approx(growth).epsilon(0.15));
  }
}

TEST_CASE("e-folds fall with the density, and are unknown beyond what was measured") {
  CHECK(*e_folds_per_collision(0.1) == 2.6);
  CHECK(*e_folds_per_collision(0.5) == 0.8);
  double last = 10;
  for (double density = 0.05; density <= 0.7; density += 0.01) {
    REQUIRE(e_folds_per_collision(density));
    CHECK(*e_folds_per_collision(density) < last);
    last = *e_folds_per_collision(density);
  }
  CHECK_FALSE(e_folds_per_collision(0.04));
  CHECK_FALSE(e_folds_per_collision(0.8));
}

TEST_CASE("Lyapunov's exponent is left out where it was not measured") {
  const auto growth_of = [](Scene scene) { return Haunted(scene, stepping("impulse", 0.01)).step(100).growth; };
  const Scene gas = melted_gas(3, 0.5, 1);
  CHECK(growth_of(gas) > 0);
  Scene falling = gas, lossy = gas, mixed = gas;
  falling.physics.gravity.y = -1;
  lossy.physics.restitution = 0.9;
  mixed.bodies.radius[0] = 0.4;
  for (const Scene& scene : {falling, lossy, mixed}) CHECK(growth_of(scene) == 0);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("a ghost costs what event-driven motion costs") {
  const Scene scene = melted_gas(8, 0.5, 1);  // 2 048 spheres
  for (const bool is_swept : {false, true}) {
    Settings settings = stepping("impulse", 0.01);
    settings.broadphase = BroadPhase::linked_cell;
    settings.is_swept = is_swept;
    double least = 1e9;
    for (int turn = 0; turn < 5; ++turn) {
      const auto exact = make_cpu_world(scene, stepping("event-driven", 0.01)), world = make_cpu_world(scene, settings);
      Ghost ghost(scene, settings, *world, 0);
      double own = 0, events = 0;
      for (int k = 0; k < 100; ++k) {
        world->step();
        const double start = spent();
        exact->step();
        const double middle = spent();
        ghost.follow(*world, world->time(), 0.01);
        events += middle - start;
        own += spent() - middle;
      }
      least = std::min(least, own / events);
    }
    CAPTURE(is_swept, least);
    CHECK(least < 1.15);
  }
}
#endif
