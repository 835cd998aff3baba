// SPDX-License-Identifier: MIT
// One thread adds up the forces along the pairs; three or more let each body gather its own. Both give the same bits.
#include <catch2/catch.hpp>

#include "tests/support/hits.h"

using namespace ballpit;

namespace {

uint64_t hash_of(const Scene& scene, Settings settings, int threads) {
  settings.precision = Precision::float32;  // only there one thread adds along the pairs
  settings.threads = threads;
  const auto world = make_cpu_world(scene, settings);
  for (int k = 0; k < 60; ++k) world->step();
  return world->report().state_hash;
}

/// Three spheres that overlap, one of them on the floor.
Scene three_spheres(int dimensions) {
  Scene scene;
  scene.domain.dimensions = dimensions;
  scene.physics.gravity = {0, -9.81, 0};
  const double z = dimensions == 3 ? 0.5 : 0;
  for (const Vec3d& p : {Vec3d(0.4, 0.049, z), Vec3d(0.48, 0.09, z), Vec3d(0.44, 0.17, z)}) add_sphere(scene, p);
  return scene;
}

}  // namespace

TEST_CASE("forces added along the pairs have the bits of forces that bodies gather") {
  const int dimensions = GENERATE(2, 3);
  const bool is_hertz = GENERATE(false, true), is_equal = GENERATE(false, true);
  const Boundary boundary = GENERATE(Boundary::walls, Boundary::periodic);
  const ContactEnd end = GENERATE(ContactEnd::overlap, ContactEnd::force);
  const double restitution = GENERATE(0.5, 1.0);
  Scene scene = make_crowd(dimensions, dimensions == 2 ? 13 : 5, boundary, restitution, 0.06, 0.07);
  if (is_equal) {
    std::fill(scene.bodies.radius.begin(), scene.bodies.radius.end(), 0.065);
    std::fill(scene.bodies.mass.begin(), scene.bodies.mass.end(), 1.25);
  }
  if (is_hertz) {
    scene.physics.law = "hertz";
    scene.physics.stiffness = 1e5;
  }
  Settings settings = settings_of("penalty", 1.0 / 960);
  settings.contact_end = end;
  const auto world = make_cpu_world(scene, settings);
  REQUIRE(world->report().contacts > 0);
  CHECK(hash_of(scene, settings, 1) == hash_of(scene, settings, 3));
}

TEST_CASE("forces of a few bodies are added to the same bits") {
  Scene scene = three_spheres(GENERATE(2, 3));
  for (size_t count = 3; count > 0; --count) {
    scene.bodies.position.resize(count);
    scene.bodies.velocity.resize(count);
    scene.bodies.radius.resize(count);
    scene.bodies.mass.resize(count);
    const Settings settings = settings_of("penalty", 1.0 / 960);
    INFO(count << " spheres");
    CHECK(hash_of(scene, settings, 1) == hash_of(scene, settings, 3));
  }
}
