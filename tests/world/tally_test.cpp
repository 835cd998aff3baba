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

namespace {

/// A way to step, and a box of 1 m with a ball of radius 0.1 m: 0.8 m of room.
struct Stepper {
  const char *response, *integrator = "auto", *solver = "jacobi";
  bool is_swept = false;
};

Settings settings_by(const Stepper& way, double dt) {
  Settings settings = tallied(way.response, dt);
  settings.integrator = named<Integrator>(way.integrator);
  settings.solver = named<Solver>(way.solver);
  settings.is_swept = way.is_swept;
  return settings;
}

const std::vector<Stepper>& steppers() {
  static const std::vector<Stepper> all{{"kinematic"},
                                        {"kinematic", "auto", "jacobi", true},
                                        {"impulse"},
                                        {"impulse", "auto", "gauss-seidel"},
                                        {"impulse", "auto", "jacobi", true},
                                        {"penalty", "explicit-euler"},
                                        {"penalty", "symplectic-euler"},
                                        {"penalty", "velocity-verlet"},
                                        {"penalty", "rk4"},
                                        {"position-based"}};
  return all;
}

Scene box_with_ball(const Vec3d& velocity, double restitution = 1) {
  Scene scene;
  scene.physics.restitution = scene.physics.wall_restitution = restitution;
  scene.physics.stiffness = 1e5;
  add_sphere(scene, {0.5, 0.5, 0.5}, velocity, 0.1, 1.0);
  return scene;
}

}  // namespace

TEST_CASE(
    "a ball between two walls hits them as often as its way says, and collides with no sphere, by every response") {
  // It meets the first wall after 0.4 m, then one every 0.8 m: 1 + ⌊(3.1 − 0.4)/0.8⌋ = 4 hits along x. Along y half of
  // this way: ⌊(1.55 − 0.4)/0.8⌋ + 1 = 2.
  for (const Stepper& way : steppers()) {
    const auto world = make_cpu_world(box_with_ball({1, 0.5, 0}), settings_by(way, 1e-4));
    step_until(*world, 3.1);
    const Tally tally = world->report().tally;
    INFO(way.response << " " << way.integrator << " " << way.solver << (way.is_swept ? " swept" : ""));
    CHECK(tally.wall_hits == 4 + 2);
    CHECK(tally.collisions == 0);
  }
}

TEST_CASE("a ball that comes to rest on the floor hits it a few times, and never again") {
  for (const Stepper& way : steppers()) {
    if (way.integrator == std::string("explicit-euler")) continue;  // never rests
    Scene scene = box_with_ball(Vec3d(0), 0.5);
    scene.physics.gravity = {0, -10, 0};
    const auto world = make_cpu_world(scene, settings_by(way, 1e-3));
    step_until(*world, 3);
    const int64_t hits = world->report().tally.wall_hits;
    step_until(*world, 6);
    INFO(way.response << " " << way.integrator << " " << way.solver << (way.is_swept ? " swept" : ""));
    CHECK(hits >= 3);
    CHECK(hits <= 20);
    CHECK(world->report().tally.wall_hits == hits);
  }
}

TEST_CASE("swept, all hits of walls in one step are counted, and a ball that hits a sphere besides") {
  for (const char* response : {"kinematic", "impulse"}) {
    const Stepper way{response, "auto", "jacobi", true};
    // 0.4 m to the first wall, then 0.8 m each: 10 in 7.7 m
    const auto world = make_cpu_world(box_with_ball({7.7, 0, 0}), settings_by(way, 1.0));
    world->step();
    CHECK(world->report().tally.wall_hits == 10);
  }
  // Two equal balls in a row: they swap velocities, and one of them hits the wall.
  Scene scene = box_with_ball({1, 0, 0});
  add_sphere(scene, {0.75, 0.5, 0.5}, Vec3d(0), 0.1, 1.0);
  const auto pair = make_cpu_world(scene, settings_by({"impulse", "auto", "jacobi", true}, 0.02));
  step_until(*pair, 0.5);
  CHECK(pair->report().tally.collisions == 2);  // there, and back
  CHECK(pair->report().tally.wall_hits == 1);
}

TEST_CASE("swept, a ball that meets a wall before another ball has hit it, and the other way round has not") {
  // The ball at 0.2 m reaches the wall after 0.1 s; the one that follows would run into it after 0.25 s, and reach the
  // wall after 0.275 s.
  Scene scene = box_with_ball({-1, 0, 0});
  scene.bodies.position[0].x = 0.2;
  add_sphere(scene, {0.65, 0.5, 0.5}, {-2, 0, 0}, 0.1, 1.0);
  const auto world = make_cpu_world(scene, settings_by({"impulse", "auto", "jacobi", true}, 0.3));
  world->step();
  CHECK(world->report().tally.wall_hits == 1);
}

TEST_CASE("a periodic domain has no walls to hit") {
  Scene scene = box_with_ball({1, 0.5, 0});
  scene.domain.boundary = Boundary::periodic;
  for (const Stepper& way : steppers()) {
    const auto world = make_cpu_world(scene, settings_by(way, 1e-2));
    step_until(*world, 2);
    CHECK(world->report().tally.wall_hits == 0);
  }
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
