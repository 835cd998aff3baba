// SPDX-License-Identifier: MIT
// The kinematic response: back to the last valid position, mirrored at the normal, without exchange of momentum.
#include <utility>

#include <catch2/catch.hpp>

#include "tests/support/hits.h"

using namespace ballpit;

TEST_CASE("a sphere that runs into one at rest is mirrored, and the other stays at rest") {
  Scene scene = wide_box();
  add_sphere(scene, {-2, 0, 0}, {1, 0, 0}, 0.5);
  add_sphere(scene, {0, 0, 0}, Vec3d(0), 0.5);
  const auto world = make_cpu_world(scene, settings_of("kinematic", 0.01));
  step_until(*world, 2);
  const Bodies bodies = world->bodies();
  CHECK(bodies.velocity[0].x == Approx(-1));
  CHECK(length(bodies.velocity[1]) == 0);
  CHECK(world->report().momentum.x == Approx(-1));  // of +1 before: plausible, not physical
}

TEST_CASE("a mirrored sphere keeps its speed and the part of its velocity along the surface") {
  Scene scene = wide_box();
  add_sphere(scene, {-2, 0.3, 0}, {1, 0.2, 0}, 0.5);
  add_sphere(scene, {0, 0, 0}, Vec3d(0), 0.5);
  const auto world = make_cpu_world(scene, settings_of("kinematic", 1e-4));
  step_until(*world, 3);
  const Bodies bodies = world->bodies();
  CHECK(length(bodies.velocity[0]) == Approx(std::sqrt(1.04)));
  CHECK(bodies.velocity[0].x < 0.9);
}

TEST_CASE("a touched sphere is back where it was last free") {
  Scene scene = wide_box();
  add_sphere(scene, {-1.25, 0, 0}, {1, 0, 0}, 0.5);
  add_sphere(scene, {0, 0, 0}, Vec3d(0), 0.5);
  const auto world = make_cpu_world(scene, settings_of("kinematic", 0.1));
  for (int k = 0; k < 3; ++k) world->step();  // at −0.95, in contact
  CHECK(world->report().max_overlap > 0);
  world->step();  // from −1.05, where it was last free, back by a step
  CHECK(world->bodies().position[0].x == Approx(-1.15));
}

TEST_CASE("walls mirror as spheres do, with their own restitution") {
  Scene scene = wide_box(2);
  scene.physics.wall_restitution = 0.5;
  add_sphere(scene, {0, 0, 0}, {0, -1, 0.25}, 0.5);
  const auto world = make_cpu_world(scene, settings_of("kinematic", 0.01));
  step_until(*world, 2);
  const Bodies bodies = world->bodies();
  CHECK(bodies.velocity[0].y == Approx(0.5));
  CHECK(bodies.velocity[0].z == Approx(0.25));
}

namespace {

Scene above_floor(double e) {
  Scene scene = wide_box(10);
  scene.domain.min.y = 0;
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.restitution = scene.physics.wall_restitution = e;
  return scene;
}

double energy(World& world) {
  const Report report = world.report();
  return report.kinetic_energy + report.potential_energy;
}

}  // namespace

TEST_CASE("kinematic balls at rest on the floor, on each other and beside a wall stay at rest") {
  const double e = GENERATE(1.0, 0.5, 0.0);
  for (const char* const precision : {"float", "double"}) {
    for (const bool is_swept : {false, true}) {
      Scene scene = above_floor(e);
      add_sphere(scene, {0, 0.1, 0}, Vec3d(0), 0.1);
      add_sphere(scene, {0, 0.3, 0}, Vec3d(0), 0.1);  // rounding may leave a gap
      add_sphere(scene, {0, 0.5 + 1e-9, 0}, Vec3d(0), 0.1);
      add_sphere(scene, {9.9, 0.1, 9.9}, Vec3d(0), 0.1);
      Settings settings = settings_of("kinematic", 1.0 / 240);
      settings.precision = named<Precision>(precision);
      settings.is_swept = is_swept;
      const auto world = make_cpu_world(scene, settings);
      const double before = energy(*world);
      step_until(*world, 30);
      INFO("e = " << e << ", " << precision << ", swept " << is_swept);
      CHECK(world->report().kinetic_energy < 1e-3);  // (g·dt)²/2 = 0.0008 J where a ball falls for a step
      CHECK(energy(*world) == Approx(before).margin(0.02));
    }
  }
}

TEST_CASE("a kinematic elastic ball keeps its energy: it flies back the way it came, kick by kick") {
  for (const double dt : {1.0 / 100, 1.0 / 240, 1.0 / 1000}) {
    Scene scene = above_floor(1);
    add_sphere(scene, {8.7, 1.05, 0}, {1.3, 0, 0.7}, 0.05);  // walls are struck, too
    const auto world = make_cpu_world(scene, settings_of("kinematic", dt));
    const auto mean_energy = [&] {
      double sum = 0;
      for (int k = 0; k < 1000; ++k) {
        world->step();
        sum += energy(*world) / 1000;
      }
      return sum;
    };
    const double before = mean_energy();
    step_until(*world, 200);
    CHECK(mean_energy() == Approx(before).epsilon(0.005));
  }
}

TEST_CASE("a kinematic gas under gravity gains and loses no energy at e = 1") {
  Scene scene = above_floor(1);
  scene.domain.max = {1, 1, 1};
  scene.domain.min = {0, 0, 0};
  Random random(3);
  for (int k = 0; k < 64; ++k) {
    add_sphere(scene, 0.24 * Vec3d(k % 4, k / 4 % 4, k / 16) + 0.14, random.direction(3), 0.04);
  }
  const auto world = make_cpu_world(scene, settings_of("kinematic", 1.0 / 1000));
  const double before = energy(*world);
  step_until(*world, 10);
  CHECK(energy(*world) == Approx(before).epsilon(0.01));
}

TEST_CASE("a kinematic ball that touches a wall, or another ball, beside it falls all the same") {
  Scene scene = above_floor(1);
  add_sphere(scene, {9.9, 5, 0}, Vec3d(0), 0.1);
  add_sphere(scene, {0, 5, 0}, Vec3d(0), 0.125);
  add_sphere(scene, {0.25, 5, 0}, Vec3d(0), 0.125);
  const auto world = make_cpu_world(scene, settings_of("kinematic", 1e-3));
  step_until(*world, 0.5);
  for (const Vec3d& p : world->bodies().position) CHECK(p.y == Approx(5 - 9.81 * 0.125).epsilon(0.002));
}

TEST_CASE("a floor carries kinematic balls that rest on it") {
  Scene scene = above_floor(0.5);
  add_sphere(scene, {0, 0.3, 0}, Vec3d(0), 0.1, 2);
  Settings settings = settings_of("kinematic", 1.0 / 240);
  settings.keeps_tally = true;
  const auto world = make_cpu_world(scene, settings);
  step_until(*world, 5);
  CHECK(world->report().tally.floor_impulse == Approx(2 * 9.81 * 5).epsilon(0.01));
}
