// SPDX-License-Identifier: MIT
// The tally of stepping worlds: what collisions exchange, how many there are, what the floor is given.
#include <catch2/catch.hpp>

#include "tests/support/hits.h"

using namespace ballpit;

namespace {

Settings tallied(const std::string& response, double dt) {
  Settings settings = settings_of(response, dt);
  settings.keeps_tally = true;
  return settings;
}

}  // namespace

TEST_CASE("a head-on hit is one collision, and its virial the impulse times the distance of the centres") {
  // Δp = (1 + e)·m*·v = 2·0.5·1, at a distance of 1 m.
  const std::string response = GENERATE("impulse", "penalty", "position-based");
  const std::string solver = GENERATE("jacobi", "gauss-seidel");
  Scene scene = head_on(1.0, 0.05);
  scene.physics.stiffness = 1e6;
  Settings settings = tallied(response, 2e-5);
  settings.solver = named<Solver>(solver);
  const auto world = make_cpu_world(scene, settings);
  step_until(*world, 0.2);
  const Tally tally = world->report().tally;
  CAPTURE(response, solver);
  CHECK(parting_speed(*world) == Approx(1).epsilon(1e-3));
  CHECK(tally.collisions == 1);
  CHECK(tally.virial == Approx(1.0).epsilon(2e-3));
  CHECK(tally.floor_impulse == 0);
}

TEST_CASE("spheres under gravity give the floor N·m·g in the mean, by every response") {
  // The impulse on the floor is what gravity gave, less what the spheres have: exact for any time.
  const std::string response = GENERATE("impulse", "penalty", "position-based");
  const std::string solver = GENERATE("jacobi", "gauss-seidel");
  Scene scene;
  scene.domain.max = {1, 4, 1};
  scene.physics.gravity = {0, -10, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 0.9;
  scene.physics.stiffness = 1e5;
  for (int k = 0; k < 27; ++k) {
    add_sphere(scene, Vec3d(0.2) + 0.3 * Vec3d(k % 3, k / 3 % 3, k / 9), {0.1 * (k % 5), 0, 0.1 * (k % 7)}, 0.1, 0.5);
  }
  Settings settings = tallied(response, 2e-4);
  settings.solver = named<Solver>(solver);
  const auto world = make_cpu_world(scene, settings);
  step_until(*world, 2);
  const Report report = world->report();
  CAPTURE(response, solver);
  CHECK(report.tally.floor_impulse == Approx(27 * 0.5 * 10 * report.time + report.momentum.y).epsilon(1e-6));
  CHECK(report.tally.collisions > 10);
}

TEST_CASE("keeping a tally does not change the motion") {
  const std::string response = GENERATE("kinematic", "impulse", "penalty", "position-based");
  Scene scene = make_cloud({.count = 200, .smallest = 0.08, .largest = 0.08, .boundary = Boundary::periodic}, 5);
  const auto hash = [&](bool keeps) {
    Settings settings = settings_of(response, 1e-4);
    settings.keeps_tally = keeps;
    settings.max_energy = 1e15;
    const auto world = make_cpu_world(scene, settings);
    for (int k = 0; k < 50; ++k) world->step();
    return world->report().state_hash;
  };
  CHECK(hash(true) == hash(false));
}
