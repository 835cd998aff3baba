// SPDX-License-Identifier: MIT
// What stops a run, and what is left of it.
#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/support/hits.h"

using namespace ballpit;

namespace {

/// Steps until the guard stops the run; its message, or nothing.
std::string stop_of(World& world, int steps) {
  try {
    for (int k = 0; k < steps; ++k) world.step();
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

/// A sphere on the floor's spring.
Scene on_spring() {
  Scene scene = wide_box(10);
  scene.physics.gravity = {0, -10, 0};
  scene.physics.stiffness = 1e4;
  add_sphere(scene, {0, -9.5, 0}, Vec3d(0), 0.5);
  add_sphere(scene, {5, -9.4999, 0}, {0, -0.2, 0}, 0.5);
  return scene;
}

}  // namespace

TEST_CASE("energy from nowhere stops the run, naming the sphere that has it, the step and the time") {
  Scene scene = on_spring();
  scene.domain.min.y = -10;
  Settings settings = settings_of("penalty", 0.019, "explicit-euler");
  settings.max_overlap = 1e6;
  settings.max_energy = 2;
  const auto world = make_cpu_world(scene, settings);
  const std::string message = stop_of(*world, 2000);
  INFO(message);
  CHECK_THAT(message, Catch::Contains("step ") && Catch::Contains("t = ") && Catch::Contains("--max-energy 2") &&
                          Catch::Contains("sphere "));
}

TEST_CASE("overlap beyond its limit stops the run, naming both spheres") {
  Scene scene = head_on(10.0, 0.1);
  scene.physics.stiffness = 100;  // far too soft
  Settings settings = settings_of("penalty", 1e-3);
  settings.max_overlap = 0.3;
  const auto world = make_cpu_world(scene, settings);
  CHECK_THAT(stop_of(*world, 100), Catch::Contains("sphere 0 overlaps sphere 1 by 0.") &&
                                       Catch::Contains("--max-overlap 0.3") && Catch::Contains("step 32 "));
}

TEST_CASE("the last good state is the one that passed the guard last, not the broken one") {
  Scene scene = head_on(10.0, 0.1);
  scene.physics.stiffness = 100;
  Settings settings = settings_of("penalty", 1e-3);
  settings.max_overlap = 0.3;
  const auto world = make_cpu_world(scene, settings), twin = make_cpu_world(scene, settings_of("penalty", 1e-3));
  CHECK_FALSE(stop_of(*world, 100).empty());
  for (int k = 0; k < 16; ++k) twin->step();
  CHECK(world->last_good_time() == Approx(0.016));
  CHECK(world->last_good().position == twin->bodies().position);
  CHECK(world->last_good().velocity == twin->bodies().velocity);
}

TEST_CASE("before the first step the last good state is the start") {
  const auto world = make_cpu_world(head_on(1, 1), settings_of("impulse", 1e-3));
  CHECK(world->last_good().position[0].x == Approx(-1));
  CHECK(world->last_good_time() == 0);
}

TEST_CASE("a start that overlaps, as a saved heap may, does not stop the run") {
  Scene scene = head_on(0.0, -0.45);
  Settings settings = settings_of("impulse", 1e-3);
  settings.max_overlap = 0.5;
  CHECK(stop_of(*make_cpu_world(scene, settings), 64).empty());
}

TEST_CASE("the last good state of so many spheres that they are sorted in memory is in the order of the scene",
          "[slow]") {
  Scene scene = make_cloud({.count = 5000, .smallest = 0.01, .largest = 0.01}, 7);
  const auto world = make_cpu_world(scene, settings_of("impulse", 1e-5));
  for (int k = 0; k < 65; ++k) world->step();  // sorted again in step 65, after the last good state
  const Bodies good = world->last_good(), now = world->bodies();
  CHECK(world->last_good_time() == Approx(64e-5));
  double largest = 0;
  for (size_t i = 0; i < good.position.size(); ++i)
    largest = std::max(largest, length(good.position[i] - now.position[i]));
  CHECK(largest < 0.01);
}

TEST_CASE("a sphere that leaves the domain stops the run in the same step with a candidate list and without") {
  Scene scene = wide_box(10);
  scene.physics.stiffness = 1;  // far too soft a wall
  for (int k = 0; k < 10; ++k) add_sphere(scene, {-4.5 + k, 0, 0}, {0, 0, k == 7 ? 2.0 : 0.0}, 0.2);
  const auto message = [&](double skin) {
    Settings settings = settings_of("penalty", 0.005);
    settings.max_overlap = 1e6;
    settings.skin = skin;
    return stop_of(*make_cpu_world(scene, settings), 5000);
  };
  CHECK_THAT(message(0.1), Catch::Contains("sphere 7 left the domain"));
  CHECK(message(0.1) == message(0));
}

TEST_CASE("while the candidate list shows that all spheres are inside, nobody else looks") {
  Scene scene = on_spring();
  const auto checks = [&](double skin) {
    Settings settings = settings_of("penalty", 1e-4);
    settings.skin = skin;
    const auto world = make_cpu_world(scene, settings);
    for (int k = 0; k < 160; ++k) world->step();
    for (const Stage& stage : world->report().stages) {
      if (stage.name == "check bodies") return stage.launches;
    }
    return int64_t{0};
  };
  CHECK(checks(0) == 160);
  CHECK(checks(0.1) == 10);  // each 16th step, for what is not seen of positions
}

TEST_CASE("energy from nowhere stops a run that begins at rest without gravity") {
  // Explicit Euler on a spring that rounding alone compresses: each step makes the oscillation larger.
  Scene scene = wide_box(10);
  scene.physics.stiffness = 1e6;
  add_sphere(scene, {-0.5 + 1e-9, 0, 0}, Vec3d(0), 0.5, 1.0);
  add_sphere(scene, {0.5, 0, 0}, Vec3d(0), 0.5, 1.0);
  Settings settings = settings_of("penalty", 0.05, "explicit-euler");
  settings.max_overlap = 1e6;
  CHECK_THAT(stop_of(*make_cpu_world(scene, settings), 64),
             Catch::Contains("--max-energy 10") || Catch::Contains("left the domain"));
}

TEST_CASE("a run that begins with next to no energy is not stopped by what gravity and springs explain") {
  const std::string response = GENERATE("impulse", "position-based", "penalty");
  Scene scene = wide_box(10);
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.stiffness = 1e5;
  scene.physics.restitution = scene.physics.wall_restitution = 0.5;
  add_sphere(scene, {0, -9.999, 0}, Vec3d(0), 0.5, 1.0);  // its centre nearly in the floor
  CHECK(stop_of(*make_cpu_world(scene, settings_of(response, 1e-4)), 2000).empty());
}

TEST_CASE("spheres at rest without gravity, in touch or overlapping, are never stopped") {
  const std::string response = GENERATE("impulse", "position-based", "penalty");
  const double gap = GENERATE(1.0, 0.0, -1e-7, -0.3);
  Scene scene = head_on(0.0, gap);
  scene.physics.stiffness = 1e4;
  CHECK(stop_of(*make_cpu_world(scene, settings_of(response, 1e-3)), 320).empty());
}

TEST_CASE("too much overlap of springs that the step resolves asks for stiffness, else for smaller steps") {
  Scene scene = head_on(10.0, 0.1);
  scene.physics.stiffness = 100;
  Settings settings = settings_of("penalty", 1e-3);
  settings.max_overlap = 0.3;
  CHECK_THAT(stop_of(*make_cpu_world(scene, settings), 100), Catch::Contains("a larger [physics] stiffness may help"));
  scene.physics.stiffness = 1e5;  // what it asks for
  CHECK(stop_of(*make_cpu_world(scene, settings), 100).empty());
  scene.physics.stiffness = 1e9;
  CHECK_THAT(stop_of(*make_cpu_world(scene, settings), 100), Catch::Contains("a smaller --dt"));
  settings.dt = 1e-6;  // what it asks for
  CHECK(stop_of(*make_cpu_world(scene, settings), 30000).empty());
}
