// SPDX-License-Identifier: MIT
// Contacts along the step: nothing passes what it would have met.
#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/support/hits.h"

using namespace ballpit;

namespace {

Settings swept(double dt, const std::string& broadphase = "brute-force") {
  Settings settings = settings_of("impulse", dt);
  settings.is_swept = true;
  settings.broadphase = named<BroadPhase>(broadphase);
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

double energy(World& world) {
  const Report report = world.report();
  return report.kinetic_energy + report.potential_energy;
}

/// A ball of radius 5 cm, 20 cm above the floor.
Scene dropped(double e) {
  Scene scene = wide_box(1);
  scene.domain.min.y = 0;
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.restitution = scene.physics.wall_restitution = e;
  add_sphere(scene, {0, 0.25, 0}, Vec3d(0), 0.05);
  return scene;
}

/// The same above a ball that is a million times as heavy, and lies on the floor.
Scene dropped_on_heavy(double e) {
  Scene scene = dropped(e);
  scene.bodies.position[0].y = 0.85;
  add_sphere(scene, {0, 0.3, 0}, Vec3d(0), 0.3, 1e6);
  return scene;
}

}  // namespace

TEST_CASE("a swept elastic ball has its energy after 1 000 bounces, as one that is not swept", "[slow]") {
  const double dt = GENERATE(1.0 / 100, 1.0 / 240, 1.0 / 1000);
  const std::string response = GENERATE("impulse", "kinematic");
  const double seconds = 1000 * 2 * std::sqrt(2 * 0.2 / 9.81);
  const auto mean_energy = [&](bool is_swept, const std::string& precision) {
    Settings settings = swept(dt);
    settings.response = named<Response>(response);
    settings.is_swept = is_swept;
    settings.precision = named<Precision>(precision);
    const auto world = make_cpu_world(dropped(1), settings);
    step_until(*world, seconds);
    double sum = 0;  // symplectic Euler's energy goes up and down by g·v·dt/2 in each bounce
    const int steps = static_cast<int>(1 / dt);
    for (int k = 0; k < steps; ++k) {
      world->step();
      sum += energy(*world) / steps;
    }
    return sum;
  };
  INFO(response << ", dt = " << dt);
  const double exact = 9.81 * 0.25, plain = mean_energy(false, "double"), in_double = mean_energy(true, "double");
  CHECK(in_double == Approx(exact).epsilon(1e-6));
  CHECK(in_double == Approx(plain).epsilon(0.01 + (response == "impulse" ? 9.81 * dt / 2 : 0)));
  CHECK(mean_energy(true, "float") == Approx(exact).epsilon(0.01));
}

TEST_CASE("a swept elastic ball keeps its energy on a heavy one that lies on the floor, and in the plane") {
  const double dt = GENERATE(1.0 / 100, 1.0 / 240, 1.0 / 1000);
  const std::string response = GENERATE("impulse", "kinematic");
  for (const int dimensions : {2, 3}) {
    Scene scene = dropped_on_heavy(1);
    scene.domain.dimensions = dimensions;
    Settings settings = swept(dt);
    settings.response = named<Response>(response);
    const auto world = make_cpu_world(scene, settings);
    const auto energy_above_rest = [&] {
      const Bodies b = world->bodies();
      return b.velocity[0].y * b.velocity[0].y / 2 + 9.81 * (b.position[0].y - 0.65);
    };
    step_until(*world, 40);  // a hundred bounces
    INFO(response << ", dt = " << dt << ", " << dimensions << " dimensions");
    CHECK(energy_above_rest() == Approx(9.81 * 0.2).epsilon(0.001));
    CHECK(world->bodies().position[1].y == Approx(0.3).margin(1e-6));
  }
}

TEST_CASE("swept balls that bounce on each other in the air keep their energy", "[slow]") {
  Scene scene = dropped(1);
  scene.domain.max.y = 3;
  add_sphere(scene, {0, 0.75, 0}, {0, -1, 0}, 0.05, 0.25);
  add_sphere(scene, {0, 1.2, 0}, {0, -0.5, 0}, 0.05, 3);
  for (const double dt : {1.0 / 500, 1.0 / 1000, 1.0 / 2000}) {
    Settings settings = swept(dt);
    settings.iterations = 100;  // two heavy balls meet at the light one, and four iterations leave much of that undone
    const auto world = make_cpu_world(scene, settings);
    const double before = energy(*world);
    step_until(*world, 20);
    CHECK(energy(*world) == Approx(before).epsilon(0.01));
  }
}

TEST_CASE("a swept ball rises to e²ⁿ of its height, off the floor and off a heavy ball, whatever the step") {
  const double dt = GENERATE(1.0 / 50, 1.0 / 240, 1.0 / 1000), e = 0.8;
  const std::string response = GENERATE("impulse", "kinematic");
  for (const bool is_on_heavy : {false, true}) {
    Settings settings = swept(dt);
    settings.response = named<Response>(response);
    const auto world = make_cpu_world(is_on_heavy ? dropped_on_heavy(e) : dropped(e), settings);
    const double rest = is_on_heavy ? 0.65 : 0.05;
    double t = std::sqrt(2 * 0.2 / 9.81), speed = 9.81 * t;
    for (int bounce = 1; bounce <= 3; ++bounce) {
      speed *= e;
      step_until(*world, t + speed / 9.81);  // about at the top
      const Bodies b = world->bodies();
      const double height = b.position[0].y - rest + b.velocity[0].y * b.velocity[0].y / (2 * 9.81);
      INFO(response << ", dt = " << dt << ", bounce " << bounce << (is_on_heavy ? " on a heavy ball" : ""));
      CHECK(height == Approx(0.2 * std::pow(e, 2 * bounce)).epsilon(is_on_heavy ? 0.01 : 1e-6));
      t += 2 * speed / 9.81;
    }
  }
}

TEST_CASE("swept steps that hold several impacts with walls lose no energy and no time") {
  Scene scene = wide_box(0.5);
  scene.physics.gravity = {0, -9.81, 0};
  add_sphere(scene, {0.12, 0.2, 0}, {7, 9, -11}, 0.2);  // 0.6 m to fly
  const auto run = [&](const std::string& response, double dt) {
    Settings settings = swept(dt);
    settings.response = named<Response>(response);
    auto world = make_cpu_world(scene, settings);
    step_until(*world, 2 - dt / 2);
    return world;
  };
  const auto fine = run("impulse", 1e-4);
  for (const char* const response : {"impulse", "kinematic"}) {
    for (const double dt : {0.01, 0.1, 0.5}) {
      const auto world = run(response, dt);
      INFO(response << ", dt = " << dt);
      CHECK(energy(*world) == Approx(125.5 + 9.81 * 0.2).epsilon(1e-9));
      CHECK(length(world->bodies().position[0] - fine->bodies().position[0]) < 1e-6);
      CHECK(length(world->bodies().velocity[0] - fine->bodies().velocity[0]) < 1e-6);
    }
  }
}

TEST_CASE("a floor carries the weight of swept balls that bounce, rest and are struck") {
  Scene scene = dropped_on_heavy(0.5);
  scene.bodies.mass[1] = 10;
  for (const char* const response : {"impulse", "kinematic"}) {
    Settings settings = swept(1.0 / 240);
    settings.response = named<Response>(response);
    settings.keeps_tally = true;
    scene.bodies.position[0] = {0.7, 0.25, 0};  // both on the floor: kinematic spheres carry nothing
    const auto world = make_cpu_world(scene, settings);
    step_until(*world, 5);
    CHECK(world->report().tally.floor_impulse == Approx(11 * 9.81 * 5).epsilon(0.002));
  }
  scene.bodies.position[0] = {0, 0.85, 0};
  Settings settings = swept(1.0 / 240);
  settings.keeps_tally = true;
  const auto world = make_cpu_world(scene, settings);
  step_until(*world, 5);
  CHECK(world->report().tally.floor_impulse == Approx(11 * 9.81 * 5).epsilon(0.01));
}

TEST_CASE("discrete contacts see a hit with probability 1 − s²/12, and 4/(3s) from s = 2 on, swept ones see all") {
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
    settings.precision = Precision::float32;
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
