// SPDX-License-Identifier: MIT
// The position-based response: the remaining overlap in a stack, restitution, and conserved quantities.
#include <catch2/catch.hpp>

#include "tests/support/hits.h"

using namespace ballpit;

namespace {

/// A stack of n spheres on the floor.
Scene stack(int n, double radius = 0.5) {
  Scene scene;
  scene.domain.min = {-2 * radius, 0, -2 * radius};
  scene.domain.max = {2 * radius, 2.5 * radius * n, 2 * radius};
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 0;
  for (int i = 0; i < n; ++i) add_sphere(scene, {0, radius + 2 * radius * i, 0}, Vec3d(0), radius, 1.0);
  return scene;
}

/// The largest overlap [m] after 5 s, in steps of 1/60 s.
double overlap_at_rest(int n, int substeps, int iterations) {
  Settings settings = settings_of("position-based", 1.0 / 60);
  settings.substeps = substeps;
  settings.iterations = iterations;
  const auto world = make_cpu_world(stack(n), settings);
  step_until(*world, 5);
  return world->report().max_overlap * 0.5;
}

}  // namespace

TEST_CASE("a stack of n rests with an overlap of (n − 1)·g·h² to 2(n − 2)·g·h² after one iteration in substeps of h") {
  // At rest contact k, which carries n − k + 1 spheres, moves each of its two by (n − k + 1)·g·h², and what is solved
  // before its neighbours keeps what they press into it. Solved from the floor up, as by Macklin et al. 2019, only the
  // floor's contact keeps something: (n − 1)·g·h². In colours one keeps what both of its neighbours press into it: 2(n
  // − 2)·g·h² at most.
  const int n = GENERATE(2, 5, 10, 20);
  const int substeps = GENERATE(10, 40);
  const double h = 1.0 / 60 / substeps, unit = 9.81 * h * h, overlap = overlap_at_rest(n, substeps, 1);
  CHECK(overlap >= 0.99 * (n - 1) * unit);
  CHECK(overlap <= 1.01 * std::max(n - 1, 2 * (n - 2)) * unit);
}

TEST_CASE("forty substeps leave a thirtieth of the overlap that forty iterations leave in a stack of twenty") {
  // Macklin et al. 2019: 3.2e-5 m and 1.0e-3 m, from the floor up; in colours both are 1.8 times as large.
  const double by_substeps = overlap_at_rest(20, 40, 1), by_iterations = overlap_at_rest(20, 1, 40);
  INFO("by substeps " << by_substeps << " m, by iterations " << by_iterations << " m");
  CHECK(by_substeps / 3.2e-5 == Approx(1.8).margin(0.1));
  CHECK(by_iterations / by_substeps == Approx(1.0e-3 / 3.2e-5).epsilon(0.15));
}

TEST_CASE("position-based spheres exchange Δp = (1 + e)·μ·(v12·n)·n head-on") {
  const double e = GENERATE(0.0, 0.5, 1.0);
  Scene scene = head_on(1.0, 0.01);
  scene.physics.restitution = e;
  scene.bodies.mass = {1.0, 3.0};
  const auto world = make_cpu_world(scene, settings_of("position-based", 1e-3));
  step_until(*world, 0.1);
  const Bodies bodies = world->bodies();
  const double impulse = (1 + e) * 0.75 * 1.0;
  CHECK(bodies.velocity[0].x == Approx(0.5 - impulse / 1.0).margin(1e-9));
  CHECK(bodies.velocity[1].x == Approx(-0.5 + impulse / 3.0).margin(1e-9));
}

TEST_CASE("position-based spheres keep momentum to rounding, in a crowd as well") {
  Scene scene = make_cloud({.count = 216, .smallest = 0.14, .largest = 0.16, .boundary = Boundary::periodic}, 4);
  for (int k = 0; k < 216; ++k) scene.bodies.position[k] = -Vec3d(5.0 / 6) + Vec3d(k % 6, k / 6 % 6, k / 36) / 3.0;
  const auto world = make_cpu_world(scene, settings_of("position-based", 1e-3));
  const Vec3d before = world->report().momentum;
  for (int k = 0; k < 50; ++k) world->step();
  CHECK(length(world->report().momentum - before) < 1e-9);
}

TEST_CASE("a ball that falls on the floor rises to e²·h") {
  Scene scene = stack(1, 0.05);
  scene.domain.max.y = 3;
  scene.physics.wall_restitution = 0.8;
  scene.bodies.position[0].y = 1.05;
  Settings settings = settings_of("position-based", 1.0 / 240);
  settings.substeps = 20;
  const auto world = make_cpu_world(scene, settings);
  step_until(*world, std::sqrt(2 / 9.81) * 1.01);
  double peak = 0;
  while (world->bodies().velocity[0].y > 0) {
    world->step();
    peak = std::max(peak, world->bodies().position[0].y - 0.05);
  }
  CHECK(peak == Approx(0.64).epsilon(0.005));
}

TEST_CASE("compliance lets a sphere at rest sink by compliance·m·g") {
  Settings settings = settings_of("position-based", 1.0 / 60);
  settings.substeps = 20;
  settings.compliance = 1e-4;
  const auto world = make_cpu_world(stack(1), settings);
  step_until(*world, 10);
  CHECK(0.5 - world->bodies().position[0].y == Approx(1e-4 * 9.81).epsilon(0.01));
}

TEST_CASE("overlap at the start is removed from position-based spheres at rest without giving them speed") {
  const double dt = GENERATE(1.0 / 240, 1e-3, 1e-4), e = GENERATE(0.0, 1.0);
  const int iterations = GENERATE(1, 10);
  Scene scene = wide_box(1);
  scene.physics.restitution = scene.physics.wall_restitution = e;
  add_sphere(scene, {0, 0, 0}, Vec3d(0), 0.1, 1.0);
  add_sphere(scene, {0.11, 0, 0}, Vec3d(0), 0.1, 1000.0);
  add_sphere(scene, {0.05, 0.1, 0}, Vec3d(0), 0.1, 0.1);
  add_sphere(scene, {-0.95, 0, 0}, Vec3d(0), 0.1, 1.0);  // in a wall
  Settings settings = settings_of("position-based", dt);
  settings.iterations = iterations;
  const auto world = make_cpu_world(scene, settings);
  for (int k = 0; k < 100; ++k) world->step();
  CHECK(world->report().kinetic_energy < 1e-12);
  CHECK(world->report().max_overlap < 1e-3);
}

TEST_CASE("two position-based spheres that overlap and fly on together keep their momentum and gain no energy") {
  Scene scene = wide_box(5);
  add_sphere(scene, {0, 0, 0}, {1, 2, 3}, 0.5, 1.0);
  add_sphere(scene, {0.3, 0.1, 0}, {1, 2, 3}, 0.5, 7.0);
  const auto world = make_cpu_world(scene, settings_of("position-based", 1e-3));
  const Report before = world->report();
  for (int k = 0; k < 100; ++k) world->step();
  CHECK(length(world->report().momentum - before.momentum) < 1e-9);
  CHECK(world->report().kinetic_energy <= before.kinetic_energy * (1 + 1e-12));
  CHECK(world->report().max_overlap < 1e-9);
}

TEST_CASE("a stack that begins squeezed to nine tenths stretches without a leap, and rests as one that did not") {
  const double dt = GENERATE(1.0 / 600, 1e-4);
  Scene scene = stack(5);
  for (int i = 0; i < 5; ++i) scene.bodies.position[size_t(i)].y = 0.45 + 0.9 * i;
  const auto world = make_cpu_world(scene, settings_of("position-based", dt));
  double most = 0;
  while (world->time() < 2) {
    world->step();
    most = std::max(most, world->report().kinetic_energy);
  }
  // Lifting the stack to its height takes 9.81·0.1·(0.5 + 1.5 + … + 4.5) J = 12.3 J.
  CHECK(most < 1.3);
  CHECK(world->report().kinetic_energy < 1e-3);
  CHECK(world->report().max_overlap * 0.5 < 1.01 * 6 * 9.81 * dt * dt);
}

TEST_CASE("a position-based run that began with overlap goes on to the same bits from a snapshot") {
  Scene scene = stack(4);
  for (int i = 0; i < 4; ++i) scene.bodies.position[size_t(i)].y = 0.45 + 0.9 * i;
  const auto world = make_cpu_world(scene, settings_of("position-based", 1e-3));
  for (int k = 0; k < 30; ++k) world->step();
  const auto then = world->snapshot();
  for (int k = 0; k < 30; ++k) world->step();
  const uint64_t once = world->report().state_hash;
  world->restore(*then);
  for (int k = 0; k < 30; ++k) world->step();
  CHECK(world->report().state_hash == once);
}
