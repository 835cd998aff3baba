// SPDX-License-Identifier: MIT
// Contacts along the step: nothing passes what it would have met.
#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/simulate/hits.h"

using namespace ballpit;

namespace {

Settings swept(double dt, const std::string& broadphase = "brute-force") {
  Settings settings = settings_of("impulse", dt);
  settings.is_swept = true;
  settings.broadphase = broadphase;
  return settings;
}

/// Part of the hits at impact parameters spread evenly over the disc that are seen, with steps of s diameters.
double seen(double s, bool is_swept) {
  constexpr int kRings = 24, kPhases = 24;
  double hits = 0;
  for (int k = 0; k < kRings; ++k) {
    const double b = std::sqrt((k + 0.5) / kRings);
    for (int phase = 0; phase < kPhases; ++phase) {
      Scene scene = wide_box();
      add_sphere(scene, {-(1.5 + (phase + 0.5) / kPhases) * s - 1, b, 0}, {1, 0, 0}, 0.5);
      add_sphere(scene, {0, 0, 0}, Vec3d(0), 0.5);
      Settings settings = swept(s);
      settings.is_swept = is_swept;
      const auto world = make_cpu_world(scene, settings);
      bool is_hit = false;
      for (int step = 0; step < 5; ++step) {
        is_hit = is_hit || world->report().contacts > 0 || length(world->bodies().velocity[1]) > 0;
        world->step();
      }
      hits += is_hit;
    }
  }
  return hits / (kRings * kPhases);
}

}  // namespace

TEST_CASE("discrete contacts see a hit with probability 1 − s²/12, and 4/(3s) from s = 2 on; swept ones see all") {
  // s = v·dt/D. The chord of a random hit is 2·√(D² − b²) long: ⟨min(1, chord/s)⟩ over the disc.
  CHECK(seen(1.0, false) == Approx(1 - 1.0 / 12).margin(0.01));
  CHECK(seen(2.0, false) == Approx(1 - 4.0 / 12).margin(0.01));
  CHECK(seen(4.0, false) == Approx(4 / (3 * 4.0)).margin(0.01));
  for (const double s : {1.0, 4.0, 10.0}) CHECK(seen(s, true) == 1.0);
}

TEST_CASE("discrete contacts see every hit while s ≤ 2·√(1 − b²/D²), and not beyond") {
  const double b = 0.6, certain = 2 * std::sqrt(1 - b * b);
  const auto misses = [&](double s) {
    int count = 0;
    for (int phase = 0; phase < 50; ++phase) {
      Scene scene = wide_box();
      add_sphere(scene, {-(1.5 + (phase + 0.5) / 50) * s - 1, b, 0}, {1, 0, 0}, 0.5);
      add_sphere(scene, {0, 0, 0}, Vec3d(0), 0.5);
      const auto world = make_cpu_world(scene, settings_of("impulse", s));
      bool is_hit = false;
      for (int step = 0; step < 5; ++step) {
        is_hit = is_hit || world->report().contacts > 0;
        world->step();
      }
      count += !is_hit;
    }
    return count;
  };
  CHECK(misses(0.98 * certain) == 0);
  CHECK(misses(1.1 * certain) > 0);
}

TEST_CASE("a swept hit has the outcome of its closed form, whatever the step") {
  // Equal masses, e = 1, offset b = D/2: the normal is 30° off the path.
  const double dt = GENERATE(0.01, 0.5, 3.0);
  Scene scene = wide_box();
  add_sphere(scene, {-2, 0.5, 0}, {1, 0, 0}, 0.5);
  add_sphere(scene, {0, 0, 0}, Vec3d(0), 0.5);
  const auto world = make_cpu_world(scene, swept(dt));
  step_until(*world, 3);
  const Bodies bodies = world->bodies();
  CHECK(bodies.velocity[1].x == Approx(0.75).epsilon(1e-6));
  CHECK(bodies.velocity[1].y == Approx(-std::sqrt(3.0) / 4).epsilon(1e-6));
  CHECK(bodies.velocity[0].x == Approx(0.25).epsilon(1e-6));
  const double impact = 2 - std::sqrt(0.75);
  CHECK(bodies.position[1].x == Approx(0.75 * (3 - impact)).epsilon(1e-6));
}

TEST_CASE("a swept bullet meets a wall, however fast, and stays inside") {
  Scene scene = wide_box(1);
  add_sphere(scene, {0, 0, 0}, {1000, 0, 0}, 0.01);
  const auto world = make_cpu_world(scene, swept(0.01));
  CHECK_THROWS_AS(make_cpu_world(scene, settings_of("impulse", 0.01))->step(), RunError);
  for (int k = 0; k < 100; ++k) world->step();
  CHECK(length(world->bodies().velocity[0]) == Approx(1000));
}

TEST_CASE("a swept sphere meets the image of another across the border of a periodic domain") {
  Scene scene = wide_box(10);
  scene.domain.boundary = Boundary::periodic;
  add_sphere(scene, {8.5, 0, 0}, {1, 0, 0}, 0.25);
  add_sphere(scene, {-8.5, 0, 0}, Vec3d(0), 0.25);
  const auto world = make_cpu_world(scene, swept(4));
  world->step();
  CHECK(world->bodies().velocity[1].x == Approx(1));
}

TEST_CASE("swept contacts are the same for every broad phase and number of threads, to the bit") {
  Scene scene = make_cloud({.count = 300, .smallest = 0.03, .largest = 0.05}, 3);
  scene.physics.gravity = {0, -9.81, 0};
  for (Vec3d& p : scene.bodies.position) p = glm::clamp(p, Vec3d(-0.9), Vec3d(0.9));
  const auto hash = [&](const std::string& broadphase, int threads) {
    Settings settings = swept(0.02, broadphase);
    settings.precision = "float";
    settings.threads = threads;
    const auto world = make_cpu_world(scene, settings);
    for (int k = 0; k < 20; ++k) world->step();
    return world->report().state_hash;
  };
  const uint64_t expected = hash("brute-force", 1);
  for (const char* const broadphase : {"sort-and-sweep", "linked-cell", "sorted-grid"}) {
    for (const int threads : {1, 8}) CHECK(hash(broadphase, threads) == expected);
  }
}
