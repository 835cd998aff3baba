// SPDX-License-Identifier: MIT
// No more than the scene needs: what cannot act is not stored, not launched and changes no bit.
#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/hits.h"

using namespace ballpit;

namespace {

constexpr int kSpheres = 64;

const std::vector<std::string>& responses() {
  static const std::vector<std::string> all{"kinematic", "impulse", "penalty", "position-based"};
  return all;
}

/// 64 spheres in motion, some about to meet, alike but for a last one in a corner of its own.
Scene spheres(int dimensions, Boundary boundary = Boundary::walls, double last_radius = 0.05, double last_mass = 1.0) {
  Random random(3);
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(2.0), boundary, dimensions};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  scene.physics.stiffness = 1e4;
  const int side = dimensions == 2 ? 8 : 4;
  for (int k = 0; k < kSpheres - 1; ++k) {
    Vec3d p = 0.5 + 0.11 * Vec3d(k % side, k / side % side, k / side / side);
    if (dimensions == 2) p.z = 0;
    add_sphere(scene, p, random.direction(dimensions));
  }
  add_sphere(scene, {1.9, 1.9, dimensions == 2 ? 0 : 1.9}, Vec3d(0.0), last_radius, last_mass);
  return scene;
}

std::unique_ptr<World> world_after(const Scene& scene, const std::string& response, int steps,
                                   const std::string& integrator = "auto", const std::string& precision = "float") {
  Settings settings = settings_of(response, 1.0 / 1000, integrator);
  settings.precision = named<Precision>(precision);
  auto world = make_cpu_world(scene, settings);
  for (int k = 0; k < steps; ++k) world->step();
  return world;
}

int64_t launches(World& world, const std::string& name) {
  int64_t sum = 0;
  for (const Stage& stage : world.report().stages) sum += stage.name == name ? stage.launches : 0;
  return sum;
}

bool any_stage_with(World& world, const std::string& part) {
  const std::vector<Stage> stages = world.report().stages;
  return std::any_of(stages.begin(), stages.end(),
                     [&](const Stage& stage) { return stage.name.find(part) != std::string::npos; });
}

/// Whether two worlds' spheres, but for the last, have the same positions and velocities.
bool are_alike(World& a, World& b) {
  const Bodies of_a = a.bodies(), of_b = b.bodies();
  return std::equal(of_a.position.begin(), of_a.position.end() - 1, of_b.position.begin()) &&
         std::equal(of_a.velocity.begin(), of_a.velocity.end() - 1, of_b.velocity.begin());
}

}  // namespace

TEST_CASE("a body takes a position and a velocity, and equal radii and masses one number each for all") {
  for (const std::string& response : responses()) {
    for (const int dimensions : {2, 3}) {
      for (const std::string& precision : {std::string("float"), std::string("double")}) {
        const int64_t real = precision == "float" ? 4 : 8;
        const auto bytes = [&](const Scene& scene) {
          return world_after(scene, response, 1, "auto", precision)->report().body_bytes;
        };
        INFO(response << ", " << dimensions << " dimensions, " << precision);
        CHECK(bytes(spheres(dimensions)) == kSpheres * 2 * dimensions * real + 2 * real);
        CHECK(bytes(spheres(dimensions, Boundary::walls, 0.06)) == kSpheres * (2 * dimensions + 1) * real + real);
        CHECK(bytes(spheres(dimensions, Boundary::walls, 0.06, 2.0)) == kSpheres * (2 * dimensions + 2) * real);
      }
    }
  }
}

TEST_CASE("a planar scene's motion takes two thirds of the memory that a body takes in space") {
  // Without contacts, which take memory of their own. In single precision penalty's forces take registers of four numbers.
  for (const std::string& response : responses()) {
    Scene planar = wide_box(), spatial = wide_box();
    planar.domain.dimensions = 2;
    planar.domain.min.z = planar.domain.max.z = 0;
    for (int k = 0; k < kSpheres; ++k) {
      add_sphere(planar, {k - 32.0, 0, 0}, {0, 1, 0}, 0.1);
      add_sphere(spatial, {k - 32.0, 0, 0}, {0, 1, 0}, 0.1);
    }
    const int64_t in_plane = world_after(planar, response, 1, "auto", "double")->report().motion_bytes,
                  in_space = world_after(spatial, response, 1, "auto", "double")->report().motion_bytes;
    INFO(response << ": " << in_plane << ", " << in_space);
    CHECK(in_plane >= 32 * kSpheres);  // the guard's last good state
    if (response == "kinematic" || response == "penalty") CHECK(3 * in_plane == 2 * in_space);
    CHECK(in_space - in_plane >= in_space / 4);  // others have counts and colours, too, of one number a body
  }
}

TEST_CASE("positions are predicted with a kick in scenes with gravity alone") {
  Scene scene = spheres(3);
  CHECK(launches(*world_after(scene, "position-based", 3), "kick") == 0);
  scene.physics.gravity = {0, -9.81, 0};
  CHECK(launches(*world_after(scene, "position-based", 3), "kick") == 3);
}

TEST_CASE("a periodic scene has no memory for walls") {
  const auto walled = world_after(spheres(3), "position-based", 3),
             periodic = world_after(spheres(3, Boundary::periodic), "position-based", 3);
  // What walls give a body, at either end of each axis.
  CHECK(walled->report().motion_bytes - periodic->report().motion_bytes == kSpheres * 2 * 12);
}

TEST_CASE("velocity Verlet evaluates forces without losses once a step, and forces that depend on velocity twice") {
  const auto evaluations = [](const Scene& scene, const std::string& integrator) {
    return launches(*world_after(scene, "penalty", 10, integrator), "accelerate");
  };
  Scene scene = spheres(3);
  CHECK(evaluations(scene, "velocity-verlet") == 11);  // and once at the start
  CHECK(evaluations(scene, "symplectic-euler") == 10);
  CHECK(evaluations(scene, "explicit-euler") == 10);
  CHECK(evaluations(scene, "rk4") == 40);
  SECTION("damped between spheres") { scene.physics.restitution = 0.9; }
  SECTION("damped at walls") { scene.physics.wall_restitution = 0.9; }
  SECTION("sheared") { scene.physics.shear = 0.1; }
  CHECK(evaluations(scene, "velocity-verlet") == 20);
  CHECK(evaluations(scene, "symplectic-euler") == 10);
}

TEST_CASE("walls that a periodic scene does not have damp nothing, and cost no evaluation of forces") {
  Scene scene = spheres(3, Boundary::periodic);
  const auto without = world_after(scene, "penalty", 10);
  scene.physics.wall_restitution = 0.5;
  const auto with = world_after(scene, "penalty", 10);
  CHECK(launches(*with, "accelerate") == launches(*without, "accelerate"));
  CHECK(with->report().state_hash == without->report().state_hash);
}

TEST_CASE("contacts are searched once a step, where the state is asked for them more often as well") {
  for (const char* const response : {"kinematic", "impulse", "penalty"}) {
    const auto world = world_after(spheres(3), response, 15);  // before the guard's first look
    INFO(response);
    CHECK(world->report().searches <= 16 + (response == std::string("penalty")));
  }
}

TEST_CASE("no tally, no sums of impulses") {
  for (const std::string& response : responses()) {
    CHECK_FALSE(any_stage_with(*world_after(spheres(3), response, 3), "impulses"));
    CHECK_FALSE(any_stage_with(*world_after(spheres(3), response, 3), "notes"));
  }
}

TEST_CASE(
    "what has no effect changes no bit: a radius and a mass each, walls out of reach, springs of another response") {
  for (const std::string& response : responses()) {
    for (const int dimensions : {2, 3}) {
      const Scene plain = spheres(dimensions);
      const auto expected = world_after(plain, response, 100);
      REQUIRE(expected->report().kinetic_energy > 0);
      INFO(response << ", " << dimensions << " dimensions");

      const auto arrays = world_after(spheres(dimensions, Boundary::walls, 0.04, 2.0), response, 100);
      REQUIRE(arrays->report().body_bytes > expected->report().body_bytes);
      CHECK(are_alike(*arrays, *expected));

      Scene open = plain;
      open.domain.boundary = Boundary::open_top;
      CHECK(world_after(open, response, 100)->report().state_hash == expected->report().state_hash);

      Scene odd = plain;
      odd.physics.gravity = {0, -0.0, 0};
      if (response != "penalty") odd.physics.stiffness = odd.physics.shear = 7;
      CHECK(world_after(odd, response, 100)->report().state_hash == expected->report().state_hash);
    }
  }
}
