// SPDX-License-Identifier: MIT
// The kinematic response: back to the last valid position, mirrored at the normal – and nothing exchanged.
#include <catch2/catch.hpp>

#include "tests/simulate/hits.h"

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
