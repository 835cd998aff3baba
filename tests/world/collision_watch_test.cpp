// SPDX-License-Identifier: MIT
// The first collision that a stepped world has late, early or not at all.
#include "world/collision_watch.h"

#include <catch2/catch.hpp>

#include "tests/support/haunted.h"

using namespace ballpit;

TEST_CASE("an impulse at the begin of the next step is late by the time from the exact collision to there") {
  for (const char* response : {"impulse", "kinematic"}) {
    Haunted haunted(meeting(), stepping(response, 0.01));
    GhostInspection seen = haunted.step(35);
    INFO(response);
    CHECK_FALSE(seen.wrong);
    CHECK(seen.curve.back().largest < 1e-12);
    seen = haunted.step(1);
    REQUIRE(seen.wrong);
    CHECK(seen.wrong->timing == Timing::open);
    seen = haunted.step(1);
    REQUIRE(seen.wrong);
    CHECK(seen.wrong->timing == Timing::late);
    CHECK(seen.wrong->time == Approx(0.353));
    CHECK(seen.wrong->late_by == Approx(0.007).epsilon(1e-6));
    CHECK(seen.wrong->place.x == Approx(0.7765));
    CHECK(std::min(seen.wrong->body, seen.wrong->partner) == 0);
    CHECK(std::max(seen.wrong->body, seen.wrong->partner) == 1);
  }
}

TEST_CASE("springs are late by half the time of a contact") {
  // t_c = π·√(μ/k) with μ = 1/2 kg: 7.02 ms
  const GhostInspection seen = Haunted(meeting(), stepping("penalty", 1e-4)).step(4000);
  REQUIRE(seen.wrong);
  CHECK(seen.wrong->timing == Timing::late);
  CHECK(seen.wrong->late_by == Approx(0.00351).epsilon(0.05));
}

TEST_CASE("swept contacts are on time") {
  for (const char* response : {"impulse", "kinematic"}) {
    const GhostInspection seen = Haunted(meeting(), stepping(response, 0.01, true)).step(60);
    CHECK_FALSE(seen.wrong);
    CHECK(seen.curve.back().largest < 1e-12);
  }
}

TEST_CASE("a collision at the very end of a step is on time, in whichever step rounding puts it") {
  for (int k = 20; k < 60; ++k) {
    Scene scene = meeting();
    scene.bodies.position[1].x = 0.5 + 0.2 + 0.01 * k;
    INFO(k);
    CHECK_FALSE(Haunted(scene, stepping("impulse", 0.01, true)).step(70).wrong);
  }
}

TEST_CASE("a wall is no partner, and has its place") {
  // The floor is reached after 0.995 s; the step that ends at 1 s finds the overlap, and the next one throws back.
  Scene scene;
  scene.domain.max = {1, 8, 1};
  scene.physics.gravity = {0, -10, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  add_sphere(scene, {0.5, 0.1 + 5 * 0.995 * 0.995, 0.5}, Vec3d(0.0), 0.1);
  const GhostInspection seen = Haunted(scene, stepping("impulse", 0.01)).step(110);
  REQUIRE(seen.wrong);
  CHECK(seen.wrong->timing == Timing::late);
  CHECK(seen.wrong->body == 0);
  CHECK(seen.wrong->partner == -1);
  CHECK(seen.wrong->time == Approx(0.995));
  CHECK(seen.wrong->late_by == Approx(0.005).epsilon(0.02));
  CHECK(seen.wrong->place.y == Approx(0).margin(1e-6));
}

TEST_CASE("a bullet that passes through a sphere has missed its collision") {
  Scene scene = wide_box(2);
  add_sphere(scene, {-1.5, 0, 0}, {100, 0, 0}, 0.05, 0.1);
  add_sphere(scene, {0.2, 0, 0}, Vec3d(0.0), 0.1);
  Haunted haunted(scene, stepping("impulse", 0.01));
  CHECK_FALSE(haunted.step(1).wrong);
  const GhostInspection seen = haunted.step(2);
  REQUIRE(seen.wrong);
  CHECK(seen.wrong->timing == Timing::missed);
  CHECK(seen.wrong->time == Approx(0.0155));
  CHECK(seen.wrong->place.x == Approx(0.1));
  CHECK(seen.curve.back().largest > 1);
}

TEST_CASE("a collision that comes in an earlier step is early") {
  // The world that the ghost follows is that of the same spheres 0.02 s later.
  Scene scene = meeting();
  const auto world = make_cpu_world(scene, stepping("event-driven", 0.01));
  Ghost ghost(scene, stepping("impulse", 0.01), *world, 0);
  for (size_t i = 0; i < 2; ++i) scene.bodies.position[i] += 0.02 * scene.bodies.velocity[i];
  const auto ahead = make_cpu_world(scene, stepping("event-driven", 0.01));
  for (int k = 0; k < 40; ++k) {
    ahead->step();
    ghost.follow(*ahead, ahead->time(), 0.01);
  }
  const GhostInspection seen = ghost.inspect(*ahead, ahead->time(), 0.01, true);
  REQUIRE(seen.wrong);
  CHECK(seen.wrong->timing == Timing::early);
  CHECK(seen.wrong->time == Approx(0.353));
  CHECK(seen.wrong->late_by == Approx(-0.02).epsilon(1e-6));
}

TEST_CASE("back where it was dropped, a ghost compares the next settings from the start") {
  const Scene scene = meeting();
  Haunted haunted(scene, stepping("impulse", 0.01));
  CHECK(haunted.step(60).wrong->late_by == Approx(0.007));
  haunted.ghost.forget_after(0);
  haunted.world = make_cpu_world(scene, stepping("impulse", 0.004));
  haunted.dt = 0.004;
  GhostInspection seen = haunted.now();
  CHECK(seen.curve.size() == 1);
  CHECK_FALSE(seen.wrong);
  CHECK_FALSE(seen.is_unwatched);
  seen = haunted.step(150);
  REQUIRE(seen.wrong);
  CHECK(seen.wrong->late_by == Approx(0.003));
}

TEST_CASE("after steps that were left out, the first wrong collision is unknown, and distances are right") {
  Haunted haunted(meeting(), stepping("impulse", 0.01));
  haunted.step(10);
  for (int k = 0; k < 30; ++k) haunted.world->step();
  const GhostInspection seen = haunted.step(10);
  CHECK(seen.is_unwatched);
  CHECK_FALSE(seen.wrong);
  CHECK(seen.curve.back().largest == Approx(0.07));  // 7 ms late, at 1 m/s
}

TEST_CASE("spheres that overlap a little when the ghost is dropped collide at once, or part") {
  Scene scene = wide_box(2);
  scene.physics.initial_overlap = 1;
  add_sphere(scene, {0, 0, 0}, {0.5, 0, 0}, 0.5);
  add_sphere(scene, {0.95, 0, 0}, {-0.5, 0, 0}, 0.5);
  Haunted haunted(scene, stepping("impulse", 0.01));
  const GhostInspection seen = haunted.step(1);
  CHECK(seen.lack.empty());
  CHECK(seen.overlap == Approx(0.1));
  CHECK_FALSE(seen.wrong);  // both collide in the first step
}
