// SPDX-License-Identifier: MIT
// Event-driven motion against closed forms and brute force.
#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/event_driven/event_oracle.h"
#include "tests/event_driven/event_worlds.h"
#include "tests/support/hard_sphere_gas.h"

using namespace ballpit;

TEST_CASE("event-driven: a bouncing ball hits the floor at the times of the closed form, within a nanosecond") {
  // t_n = t1·[1 + 2e(1 − e^(n−1))/(1 − e)], t1 = √(2·h0/g).
  const double t1 = std::sqrt(2 / 9.81), e = 0.8, v0 = 9.81 * t1;
  const int n = GENERATE(1, 2, 5, 10, 30);
  const double t_n = t1 * (1 + 2 * e * (1 - std::pow(e, n - 1)) / (1 - e));
  if (n == 2) CHECK(t_n == Approx(1.173961467).margin(1e-9));
  if (n == 5) CHECK(t_n == Approx(2.584160102).margin(1e-9));
  // The floor's impulse after n hits: m·(1 + e)·v0·Σ e^k.
  const auto impulse_after = [&](int hits) { return 2.0 * (1 + e) * v0 * (1 - std::pow(e, hits)) / (1 - e); };
  CHECK(world_at(dropped_ball(), t_n - 1e-9)->report().tally.floor_impulse ==
        Approx(impulse_after(n - 1)).epsilon(1e-12));
  CHECK(world_at(dropped_ball(), t_n + 1e-9)->report().tally.floor_impulse == Approx(impulse_after(n)).epsilon(1e-12));
}

TEST_CASE("event-driven: hits of walls are counted, with any restitution, until a ball rests") {
  const double t1 = std::sqrt(2 / 9.81), rest = t1 * 1.8 / 0.2;
  CHECK(world_at(dropped_ball(), t1 - 1e-9)->report().tally.wall_hits == 0);
  CHECK(world_at(dropped_ball(), t1 + 1e-9)->report().tally.wall_hits == 1);
  CHECK(world_at(dropped_ball(), t1 * 2.61)->report().tally.wall_hits == 2);  // the second is at (1 + 2·0.8)·t1
  const auto hits = [&](double t) { return world_at(dropped_ball(), t, 1e-4)->report().tally.wall_hits; };
  CHECK(hits(rest + 1) == hits(rest + 2));
  CHECK(hits(rest + 1) < 60);
  CHECK(world_at(dropped_ball(), rest + 1, 1e-4)->report().events > 5000);  // it lies there by events

  // A corner of walls, and walls that take all speed.
  const double e = GENERATE(0.0, 0.5, 1.0);
  Scene scene = empty_box(2.0);
  scene.physics.wall_restitution = e;
  add_sphere(scene, {0.6, 0.7, 1.0}, {-1, -1, 0}, 0.1);
  CHECK(world_at(scene, 0.55)->report().tally.wall_hits == 1);
  CHECK(world_at(scene, 0.65)->report().tally.wall_hits == 2);
  CHECK(world_at(scene, 0.65)->report().tally.collisions == 0);
}

TEST_CASE("event-driven: two spheres exchange Δp = (1 + e)·μ·(v12·n)·n and keep their tangential parts") {
  const double e = GENERATE(0.0, 0.5, 1.0);
  Scene scene = empty_box();
  scene.physics.restitution = e;
  const double m1 = 1.0, m2 = 3.0;
  // They meet at t = 1 with the normal n = (0.6, 0.8, 0).
  const Vec3d v1(2, 0.3, 0), v2(-1, -0.5, 0.7), n(0.6, 0.8, 0), meeting(5, 5, 5);
  add_sphere(scene, meeting - v1, v1, 0.3, m1);
  add_sphere(scene, meeting + 0.8 * n - v2, v2, 0.5, m2);
  CHECK(world_at(scene, 1 - 1e-9)->report().tally.collisions == 0);
  const auto world = world_at(scene, 1 + 1e-9);
  REQUIRE(world->report().tally.collisions == 1);
  const double impulse = (1 + e) * m1 * m2 / (m1 + m2) * dot(v1 - v2, n);
  const Bodies after = world->bodies();
  CHECK(length(after.velocity[0] - (v1 - impulse / m1 * n)) < 1e-13);
  CHECK(length(after.velocity[1] - (v2 + impulse / m2 * n)) < 1e-13);
  CHECK(world->report().tally.virial == Approx(impulse * 0.8).epsilon(1e-13));
  CHECK(world->report().contacts == 1 - (e > 0));
}

TEST_CASE("event-driven: in a cradle of touching spheres the last one leaves with the speed of the first") {
  const int count = GENERATE(3, 5);
  const auto world = world_at(cradle(count, 1.0), 4.0);
  const Bodies after = world->bodies();
  for (int k = 0; k < count; ++k) {
    CHECK(length(after.velocity[size_t(k)] - Vec3d(k == count - 1 ? 1 : 0, 0, 0)) < 1e-14);
  }
  CHECK(world->report().tally.collisions == count - 1);
  CHECK(after.position.back().x == Approx(3.0 + count - 1 + 3).margin(1e-12));
}

TEST_CASE("event-driven: spheres that meet three at a time keep energy and momentum, and have one order") {
  // A break: one sphere hits a triangle of touching ones head-on, two of them at the same moment.
  Scene scene = empty_box();
  scene.domain.dimensions = 2;
  const double h = std::sqrt(0.75);
  for (const Vec3d& p : {Vec3d(5, 5, 0), Vec3d(6, 5, 0), Vec3d(5.5, 5 - h, 0)}) add_sphere(scene, p, Vec3d(0.0), 0.5);
  add_sphere(scene, {5.5, 8, 0}, {0, -1, 0}, 0.5);
  const auto world = world_at(scene, 3.0);
  const Report report = world->report();
  CHECK(report.kinetic_energy == Approx(0.5).epsilon(1e-13));
  CHECK(length(report.momentum - Vec3d(0, -1, 0)) < 1e-13);
  CHECK(report.max_overlap < 1e-12);
  CHECK(report.state_hash == world_at(scene, 3.0)->report().state_hash);
}

TEST_CASE("event-driven: the motion does not depend on dt, to the last bit") {
  const uint64_t once = world_at(mixed_heap(), 1.0)->report().state_hash;
  for (const int steps : {4, 64, 1024}) {
    const auto world = make_cpu_world(mixed_heap(), event_driven(1.0 / steps));
    for (int k = 0; k < steps; ++k) {
      world->step();
      if (k % 7 == 0) world->report();
    }
    CHECK(world->report().state_hash == once);
  }
}

TEST_CASE("event-driven: the same scene gives the same bits twice") {
  const Scene scene = make_lattice_gas(3, 0.7, 11);
  CHECK(world_at(scene, 5.0)->report().state_hash == world_at(scene, 5.0)->report().state_hash);
  CHECK(world_at(scene, 5.0)->report().state_hash != world_at(make_lattice_gas(3, 0.7, 12), 5.0)->report().state_hash);
}

TEST_CASE("event-driven: every collision comes as brute force finds it", "[slow]") {
  const int dimensions = GENERATE(3, 2);
  const Boundary boundary = GENERATE(Boundary::walls, Boundary::open_top, Boundary::periodic);
  const uint64_t seed = GENERATE(1, 2, 3, 4);
  const Scene scene = make_oracle_scene(dimensions, boundary, seed);
  EventOracle oracle(scene);
  while (oracle.collisions() < 60) oracle.next_event();
  const double end = oracle.time();
  const auto world = world_at(scene, end + 1e-9, 0.0);
  oracle.advance(end + 1e-9);
  CHECK(world->report().tally.collisions == oracle.collisions());
  const Bodies bodies = world->bodies();
  for (int i = 0; i < bodies.size(); ++i) {
    INFO("sphere " << i);
    CHECK(oracle.distance_to(i, bodies.position[size_t(i)]) < 1e-9);
    CHECK(length(oracle.velocity(i) - bodies.velocity[size_t(i)]) < 1e-8);
  }
}

TEST_CASE("event-driven: two spheres in a periodic domain meet again across its border") {
  // Spheres of diameter 1 in a row of length 10, at a relative speed of 2: they meet after 2 m, then every 8 m.
  Scene scene = empty_box(10.0);
  scene.domain.boundary = Boundary::periodic;
  add_sphere(scene, {3, 9.9, 0.2}, {1, 0, 0}, 0.5);
  add_sphere(scene, {6, 9.9, 0.2}, {-1, 0, 0}, 0.5);
  for (int n = 1; n < 50; ++n) {
    const double t_n = 1 + 4.0 * (n - 1);
    CHECK(world_at(scene, t_n - 1e-9)->report().tally.collisions == n - 1);
    CHECK(world_at(scene, t_n + 1e-9)->report().tally.collisions == n);
  }
}

TEST_CASE("event-driven: a periodic domain as small as two diameters holds all images") {
  Scene scene = empty_box(2.0);
  scene.domain.boundary = Boundary::periodic;
  add_sphere(scene, {0.2, 0.2, 0.2}, {0.7, 0.2, -0.1}, 0.5);
  add_sphere(scene, {1.4, 1.2, 1.2}, {-0.3, 0.5, 0.9}, 0.5);
  const auto world = make_cpu_world(scene, event_driven(1));
  for (int k = 0; k < 200; ++k) {
    world->step();
    REQUIRE(world->report().max_overlap < 1e-10);
  }
  CHECK(world->report().tally.collisions > 100);
}

TEST_CASE("event-driven: an open top lets spheres rise far above it and fall back in time") {
  Scene scene = empty_box(1.0);
  scene.domain.boundary = Boundary::open_top;
  scene.physics.gravity = {0, -10, 0};
  add_sphere(scene, {0.5, 0.1, 0.5}, {0.1, 100, 0}, 0.1);
  add_sphere(scene, {0.5, 0.4, 0.5}, {0.1, 90, 0}, 0.1, 2.0);
  const Bodies bodies = world_at(scene, 1e-3)->bodies();
  CHECK(bodies.velocity[0].y == Approx(99.99));
  const auto flying = world_at(scene, 5.0);  // the lower one caught up at t = 0.01 s
  CHECK(flying->report().tally.collisions == 1);
  const double pushed = (2 * 100 + 90) / 3.0;  // of masses 1 and 2, at speeds 100 and 90
  CHECK(flying->bodies().position[1].y == Approx(0.4 + 0.01 * 90 + 4.99 * pushed - 125));
  CHECK(total_energy(world_at(scene, 60.0)->report()) == Approx(total_energy(flying->report())).epsilon(1e-12));
}

TEST_CASE("event-driven: a fast sphere does not pass through a small one") {
  Scene scene = empty_box(100.0);
  add_sphere(scene, {1, 50, 50}, {1e6, 0, 0}, 0.01);
  add_sphere(scene, {90, 50, 50}, Vec3d(0.0), 0.01);
  const Bodies after = world_at(scene, 89e-6)->bodies();
  CHECK(after.velocity[0].x == Approx(0).margin(1e-6));
  CHECK(after.velocity[1].x == Approx(1e6));
}

TEST_CASE("event-driven: the cells of a vast empty domain are few, and nothing is missed in them") {
  Scene scene = empty_box(1e7);
  for (int k = 0; k < 2; ++k) {
    for (const Vec3d& p : {Vec3d(2, 2, 2), Vec3d(9e6, 9e6, 9e6)}) {
      add_sphere(scene, p + Vec3d(3.0 * k, 0, 0), {1.0 - k, 0, 0}, 0.5);
    }
  }
  const auto world = world_at(scene, 3.0);
  CHECK(world->report().tally.collisions == 2);
  CHECK(world->report().detection_bytes < 100000);
}

TEST_CASE("event-driven: what is inspected is the state of the report") {
  const auto world = world_at(mixed_heap(), 0.7);
  const Inspection seen = world->inspect();
  const Bodies bodies = world->bodies();
  REQUIRE(seen.bodies.count == 60);
  for (int i = 0; i < 60; ++i) CHECK(length(Vec3d(seen.bodies.position_of(i)) - bodies.position[size_t(i)]) < 1e-6);
  CHECK(int64_t(seen.contacts.size()) == world->report().contacts);
  REQUIRE(seen.grids.size() == 1);
  const GridInspection& grid = seen.grids[0];
  int listed = 0;
  for (size_t c = 0; c < grid.head.size(); ++c) {
    for (int i = grid.head[c]; i >= 0; i = grid.next[size_t(i)]) {
      ++listed;
      const int x = int((bodies.position[size_t(i)].x - double(grid.origin.x)) / double(grid.edge.x));
      CHECK(x == int(c) % grid.cells.x);
    }
  }
  CHECK(listed == 60);
}

TEST_CASE("event-driven: a world started from another's bodies goes on in the same way") {
  const Scene scene = make_lattice_gas(2, 0.5, 1);
  const auto world = make_cpu_world(scene, event_driven(0.5));
  world->step();
  Scene half = scene;
  half.bodies = world->bodies();
  world->step();
  const Bodies expected = world->bodies(), resumed = world_at(half, 0.5)->bodies();
  for (size_t i = 0; i < 32; ++i) CHECK(length(expected.velocity[i] - resumed.velocity[i]) < 1e-8);
}

TEST_CASE("event-driven: a state that is not finite stops the run and names sphere, event and time") {
  Scene scene = make_lattice_gas(2, 0.5, 1);
  scene.bodies.velocity[17].y = std::nan("");
  try {
    world_at(scene, 1.0);
    FAIL("ran on");
  } catch (const RunError& error) {
    CHECK_THAT(error.what(), Catch::Contains("event 0 (t = 0 s), sphere 17"));
  }
}
