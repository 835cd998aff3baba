// SPDX-License-Identifier: MIT
// The promises of a world: looking changes nothing, nothing leaves unseen. Its sibling on the same bits: same_bits_test.cpp.
#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/support/scenes.h"

using namespace ballpit;

TEST_CASE("looking at a world does not change its motion") {
  const Scene scene = falling_cloud(600);
  const auto watched = make_cpu_world(scene), alone = make_cpu_world(scene);
  for (int k = 0; k < 50; ++k) {
    (void)watched->inspect();
    (void)watched->report();
    watched->step();
    alone->step();
  }
  CHECK(watched->report().state_hash == alone->report().state_hash);
}

TEST_CASE("the state hash differs between states that differ in one bit") {
  Scene scene = falling_cloud(600);
  const uint64_t before = make_cpu_world(scene)->report().state_hash;
  scene.bodies.position[17].x = std::nextafter(float(scene.bodies.position[17].x), 2.0f);
  CHECK(make_cpu_world(scene)->report().state_hash != before);
}

TEST_CASE("a sphere that leaves the domain stops the run, with its number and the step") {
  Scene scene;
  add_sphere(scene, {0.5, 0.5, 0.5});
  add_sphere(scene, {0.2, 0.5, 0.5}, {-100, 0, 0});
  Settings settings;
  settings.dt = 0.01;
  const auto world = make_cpu_world(scene, settings);
  CHECK_THROWS_WITH(world->step(),
                    Catch::Contains("step 1 ") && Catch::Contains("sphere 1") && Catch::Contains("--dt"));
}

TEST_CASE("a velocity that is not a number stops the run") {
  Scene scene;
  add_sphere(scene, {0.5, 0.5, 0.5}, {std::nan(""), 0, 0});
  const auto world = make_cpu_world(scene);
  CHECK_THROWS_AS(world->step(), RunError);
}

TEST_CASE("a report adds up energy, momentum and time") {
  Scene scene;
  scene.domain.max = Vec3d(10.0);
  scene.physics.gravity = {0, -10, 0};
  add_sphere(scene, {1, 2, 3}, {1, 2, 2}, 0.1, 2.0);
  add_sphere(scene, {5, 4, 3}, {0, 0, -1}, 0.2, 4.0);
  Settings settings;
  settings.dt = 0.25;
  const auto world = make_cpu_world(scene, settings);
  Report report = world->report();
  CHECK(report.count == 2);
  CHECK(report.kinetic_energy == Approx(0.5 * 2 * 9 + 0.5 * 4 * 1));
  CHECK(report.potential_energy == Approx(2 * 10 * 2 + 4 * 10 * 4));
  CHECK(report.momentum.x == Approx(2));
  CHECK(report.momentum.y == Approx(4));
  CHECK(report.momentum.z == Approx(4 - 4));
  world->step();
  report = world->report();
  CHECK(report.steps == 1);
  CHECK(report.time == 0.25);
  CHECK(report.seconds > 0);
  CHECK_FALSE(report.stages.empty());
}

TEST_CASE("the largest overlap is reported as a fraction of the smaller radius, walls included") {
  Scene scene;
  add_sphere(scene, {0.5, 0.5, 0.5}, Vec3d(0.0), 0.1);
  add_sphere(scene, {0.64, 0.5, 0.5}, Vec3d(0.0), 0.05);
  CHECK(make_cpu_world(scene)->report().max_overlap == Approx(0.01 / 0.05).epsilon(1e-4));
  scene.bodies.position[1].x = 0.02;
  CHECK(make_cpu_world(scene)->report().max_overlap == Approx(0.03 / 0.05).epsilon(1e-4));
}

TEST_CASE("equal radii and masses are stored once, planar positions with two coordinates") {
  Scene scene;
  scene.domain.dimensions = 2;
  for (int k = 0; k < 3; ++k) add_sphere(scene, {0.2 + 0.2 * k, 0.5, 0});
  const Inspection seen = make_cpu_world(scene)->inspect();
  CHECK(seen.bodies.radius.size() == 1);
  CHECK(seen.bodies.position.size() == 6);
}

TEST_CASE("worlds of zero and one sphere step and report") {
  for (const int dimensions : {2, 3}) {
    Scene scene;
    scene.domain.dimensions = dimensions;
    auto world = make_cpu_world(scene);
    world->step();
    CHECK(world->report().count == 0);
    add_sphere(scene, {0.5, 0.5, 0.5}, {0.1, 0, 0});
    world = make_cpu_world(scene);
    world->step();
    CHECK(world->report().momentum.x == Approx(0.1));
  }
}

TEST_CASE("substeps divide the step") {
  Scene scene = falling_cloud(600);
  Settings whole, parts;
  whole.dt = 1.0 / 960;
  parts.dt = 1.0 / 240;
  parts.substeps = 4;
  const auto a = make_cpu_world(scene, whole), b = make_cpu_world(scene, parts);
  for (int k = 0; k < 40; ++k) a->step();
  for (int k = 0; k < 10; ++k) b->step();
  CHECK(a->report().state_hash == b->report().state_hash);
  CHECK(a->time() == Approx(b->time()));
}
