// SPDX-License-Identifier: MIT
// The impulse response with symplectic Euler, against closed formulas.
#include <catch2/catch.hpp>

#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

Scene empty_box(double size = 10.0) {
  Scene scene;
  scene.domain.max = Vec3d(size);
  scene.physics.restitution = scene.physics.wall_restitution = 1.0;
  return scene;
}

Settings step_of(double dt) {
  Settings settings;
  settings.dt = dt;
  return settings;
}

}  // namespace

TEST_CASE("two spheres exchange Δp = (1 + e)·μ·(v12·n)·n and keep their tangential parts") {
  const double e = GENERATE(0.0, 0.5, 1.0);
  Scene scene = empty_box();
  scene.physics.restitution = e;
  const double m1 = 1.0, m2 = 3.0;
  add_sphere(scene, {4.5, 5, 5}, {2.0, 0.3, 0}, 0.5, m1);
  add_sphere(scene, {5.49, 5, 5}, {-1.0, 0.0, 0.7}, 0.5, m2);
  const auto world = make_cpu_world(scene, step_of(1e-3));
  const Vec3d before = world->report().momentum;
  world->step();
  const Bodies after = world->bodies();
  const double impulse = (1 + e) * m1 * m2 / (m1 + m2) * 3.0;
  CHECK(after.velocity[0].x == Approx(2.0 - impulse / m1));
  CHECK(after.velocity[1].x == Approx(-1.0 + impulse / m2));
  CHECK(after.velocity[0].y == Approx(0.3));
  CHECK(after.velocity[1].z == Approx(0.7));
  CHECK(length(world->report().momentum - before) < 1e-6);
}

TEST_CASE("the momentum of two free spheres is conserved to rounding through an oblique hit") {
  Scene scene = empty_box();
  add_sphere(scene, {4, 5, 5}, {1.0, 0.1, -0.05}, 0.5, 1.0);
  add_sphere(scene, {6, 5.3, 5.2}, {-0.7, 0.0, 0.0}, 0.4, 0.5);
  const auto world = make_cpu_world(scene, step_of(1.0 / 240));
  const Report before = world->report();
  bool touched = false;
  for (int k = 0; k < 400; ++k) {
    world->step();
    touched = touched || world->report().contacts > 0;
  }
  const Report after = world->report();
  CHECK(touched);
  CHECK(std::fabs(world->bodies().velocity[0].x - 1.0) > 0.1);
  CHECK(length(after.momentum - before.momentum) < 1e-6 * length(before.momentum) + 1e-6);
  CHECK(after.kinetic_energy == Approx(before.kinetic_energy).epsilon(1e-5));
}

TEST_CASE("a bouncing ball rises to e²ⁿ of its height, within the scheme's error") {
  // Closed form: h_n = e^(2n)·h0 for the lowest point of the ball. The scheme is first order in dt: an impact is
  // noticed up to dt late, at a speed with an error of up to g·dt, so h_n has an error of about n·v·dt.
  const double e = GENERATE(0.8, 1.0), dt = GENERATE(1.0 / 240, 1.0 / 2000);
  const double h0 = 1.0, g = 9.81, r = 0.05;
  Scene scene = empty_box(2.0);
  scene.physics.gravity = {0, -g, 0};
  scene.physics.wall_restitution = e;
  add_sphere(scene, {1, h0 + r, 1}, Vec3d(0.0), r);
  const auto world = make_cpu_world(scene, step_of(dt));
  std::vector<double> peaks;
  double last = h0;
  bool is_falling = true;
  while (peaks.size() < 3 && world->time() < 6) {
    world->step();
    const double h = world->bodies().position[0].y - r;
    if (h < last && !is_falling) peaks.push_back(last);
    is_falling = h < last;
    last = h;
  }
  REQUIRE(peaks.size() == 3);
  const double v0 = std::sqrt(2 * g * h0);
  for (size_t n = 0; n < peaks.size(); ++n) {
    const double expected = std::pow(e, 2.0 * double(n + 1)) * h0;
    INFO("bounce " << n + 1 << ", e = " << e << ", dt = " << dt << ": " << peaks[n] << " for " << expected);
    CHECK(std::fabs(peaks[n] - expected) < double(n + 1) * v0 * dt);
  }
}

TEST_CASE("an elastic ball neither gains nor loses height over a hundred bounces") {
  const double h0 = 0.3, g = 9.81, r = 0.05, dt = 1.0 / 1000;
  Scene scene = empty_box(2.0);
  scene.physics.gravity = {0, -g, 0};
  add_sphere(scene, {1, h0 + r, 1}, Vec3d(0.0), r);
  const auto world = make_cpu_world(scene, step_of(dt));
  double highest = 0;
  for (int k = 0; k < 50000; ++k) {
    world->step();
    if (k > 49000) highest = std::max(highest, world->bodies().position[0].y - r);
  }
  CHECK(highest == Approx(h0).epsilon(0.02));
}

TEST_CASE("a ball at rest on the floor stays at rest") {
  Scene scene = empty_box(2.0);
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.wall_restitution = 0.5;
  add_sphere(scene, {1, 0.05, 1}, Vec3d(0.0), 0.05);
  const auto world = make_cpu_world(scene, step_of(1.0 / 60));
  for (int k = 0; k < 600; ++k) world->step();
  CHECK(world->bodies().position[0].y == Approx(0.05).margin(0.05 * 0.01));
  CHECK(world->report().kinetic_energy < 1e-9);
}

TEST_CASE("a sphere that hits several at once gains no energy") {
  // A ball falls into the hollow between two heavy ones: if each contact answered in full, both would throw
  // it back with more than its energy.
  Scene scene = empty_box();
  add_sphere(scene, {4.45, 5, 5}, Vec3d(0.0), 0.5, 1e6);
  add_sphere(scene, {5.55, 5, 5}, Vec3d(0.0), 0.5, 1e6);
  add_sphere(scene, {5.0, 5.8, 5}, {0, -1, 0}, 0.5, 1.0);
  const auto world = make_cpu_world(scene, step_of(1e-3));
  const double before = world->report().kinetic_energy;
  REQUIRE(world->report().contacts == 2);
  world->step();
  CHECK(world->report().kinetic_energy <= before * (1 + 1e-5));
  CHECK(world->bodies().velocity[2].y > 0);
}

TEST_CASE("a dissipative heap never gains energy") {
  Scene scene = make_cloud({.count = 400, .smallest = 0.06, .largest = 0.1}, 2);
  scene.physics.restitution = scene.physics.wall_restitution = 0.0;
  const auto world = make_cpu_world(scene, step_of(1e-3));
  double last = world->report().kinetic_energy;
  REQUIRE(world->report().contacts > 100);
  for (int k = 0; k < 200; ++k) {
    world->step();
    const double now = world->report().kinetic_energy;
    CHECK(now <= last * (1 + 1e-6));
    last = now;
  }
}

TEST_CASE("without gravity, overlapping spheres are pushed apart without gaining speed") {
  Scene scene = empty_box();
  add_sphere(scene, {4.6, 5, 5}, Vec3d(0.0), 0.5);
  add_sphere(scene, {5.4, 5, 5}, Vec3d(0.0), 0.5);
  const auto world = make_cpu_world(scene, step_of(1.0 / 60));
  for (int k = 0; k < 60; ++k) world->step();
  CHECK(world->report().max_overlap < 0.011);
  CHECK(world->report().kinetic_energy < 1e-12);
}

TEST_CASE("a heap comes to rest with little overlap") {
  // A dropped column of n = 10 layers must neither collapse nor jump. The lowest contact has to transfer
  // n·m·g·dt a step; at an overlap of d it pushes with push·d/dt times the part m/c of the mass, hence
  // d = c/push·n·g·dt², where c = 6 contacts share a sphere and push = 0.8; and the slop of 0.5 % of both radii.
  Scene scene;
  scene.domain.max = {0.5, 2.0, 0.5};
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 0.5;
  for (int k = 0; k < 160; ++k) {
    const double jitter = 0.003 * ((k * 37) % 11 - 5);
    add_sphere(scene, {0.06 + 0.125 * (k % 4) + jitter, 0.06 + 0.11 * (k / 16), 0.06 + 0.125 * (k / 4 % 4) - jitter},
               Vec3d(0.0), 0.05);
  }
  const auto world = make_cpu_world(scene, step_of(1.0 / 480));
  for (int k = 0; k < 5 * 480; ++k) world->step();
  const Report report = world->report();
  const double rms_speed = std::sqrt(2 * report.kinetic_energy / 160);
  CHECK(report.max_overlap * 0.05 < 6 / 0.8 * 10 * 9.81 / 480 / 480 + 0.01 * 0.05);
  CHECK(rms_speed < 0.03);
  CHECK(report.contacts > 160);
}

TEST_CASE("a dropped ball that does not bounce stays on the floor") {
  // The overlap of the impact is removed by moving the ball: pushed out by velocity, it would hop.
  Scene scene = empty_box(3.0);
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.wall_restitution = 0.0;
  add_sphere(scene, {1, 1.0, 1}, Vec3d(0.0), 0.05);
  const auto world = make_cpu_world(scene, step_of(1.0 / 240));
  double highest = 0;
  for (int k = 0; k < 480; ++k) {
    world->step();
    if (world->time() > 0.5) highest = std::max(highest, world->bodies().position[0].y);
  }
  CHECK(highest < 0.0501);
  CHECK(world->bodies().position[0].y > 0.0490);
}

TEST_CASE("a periodic domain has no walls and carries spheres across its border") {
  Scene scene = empty_box(1.0);
  scene.domain.boundary = Boundary::periodic;
  scene.physics.wall_restitution = 0.0;
  add_sphere(scene, {0.9, 0.5, 0.5}, {1, 0, 0});
  const auto world = make_cpu_world(scene, step_of(0.01));
  for (int k = 0; k < 30; ++k) world->step();
  CHECK(world->bodies().position[0].x == Approx(0.2).margin(1e-4));
  CHECK(world->bodies().velocity[0].x == 1.0);
}

TEST_CASE("an open top lets spheres rise above it and fall back") {
  Scene scene = empty_box(1.0);
  scene.domain.boundary = Boundary::open_top;
  scene.physics.gravity = {0, -10, 0};
  add_sphere(scene, {0.5, 0.9, 0.5}, {0, 4, 0});
  const auto world = make_cpu_world(scene, step_of(0.001));
  double highest = 0;
  for (int k = 0; k < 800; ++k) {
    world->step();
    highest = std::max(highest, world->bodies().position[0].y);
  }
  CHECK(highest == Approx(1.7).margin(0.01));
  CHECK(world->bodies().velocity[0].y == Approx(-4).margin(0.01));
}
