// SPDX-License-Identifier: MIT
// Hard cases of event-driven motion: rounding, touching spheres, and collisions that follow each other ever faster.
#include <catch2/catch.hpp>

#include "core/error.h"
#include "event_driven/flight.h"
#include "tests/event_driven/event_worlds.h"
#include "tests/support/hard_sphere_gas.h"

using namespace ballpit;

TEST_CASE("event-driven: the time of a contact is exact where the textbook's formula is not") {
  // Head-on across a gap of 1e-12 radii, where b² is 1e24 times the difference of the roots.
  const double gap = 0x1p-40;
  CHECK(time_to_contact(Vec3d(1 + gap, 0, 0), Vec3d(-0.5, 0, 0), 1.0) == Approx(2 * gap).epsilon(1e-12));
  // The plane likewise, under gravity: distance = approach·t + acceleration·t²/2.
  CHECK(time_to_plane(gap, 0.5, 10.0) == Approx(2 * gap).epsilon(1e-10));
  CHECK(time_to_plane(gap, 0.5, -10.0) == Approx(2 * gap).epsilon(1e-10));
}

TEST_CASE("event-driven: spheres in touch collide at once if they approach, and never if they part or slide") {
  const Vec3d touching(1 - 1e-15, 0, 0);
  CHECK(time_to_contact(touching, Vec3d(-1e-9, 0, 0), 1.0) == 0);
  CHECK(time_to_contact(touching, Vec3d(1e-9, 0, 0), 1.0) == kNever);
  CHECK(time_to_contact(touching, Vec3d(-1e-16, 3, 4), 1.0) == kNever);
  CHECK(time_to_contact(touching, Vec3d(0.0), 1.0) == kNever);
}

TEST_CASE("event-driven: a sphere at a plane meets it at once if it approaches, and when it falls back otherwise") {
  CHECK(time_to_plane(-1e-15, 1.0, 0.0) == 0);
  CHECK(time_to_plane(-1e-15, 0.0, 0.0) == kNever);
  CHECK(time_to_plane(-1e-15, -1.0, -9.0) == kNever);
  CHECK(time_to_plane(-1e-15, -1.0, 10.0) == Approx(0.2));
  CHECK(time_to_plane(0.0, 0.0, 10.0) == 0);
  CHECK(time_to_plane(5.0, 1.0, -1.0) == kNever);  // turns round before
}

TEST_CASE("event-driven: after a collision without restitution the spheres do not approach, however they are rounded") {
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    Scene scene = empty_box();
    scene.physics.restitution = 0;
    const Vec3d n = random.direction(3), common = 0.3 * random.direction(3), center(5, 5, 5);
    add_sphere(scene, center, common + 0.1 * n, 0.5, random.uniform(0.5, 2.0));
    add_sphere(scene, center + 1.001 * n, common, 0.5);
    const auto world = world_at(scene, 0.02);
    REQUIRE(world->report().tally.collisions == 1);
    const Bodies after = world->bodies();
    const Vec3d d = after.position[1] - after.position[0], u = after.velocity[1] - after.velocity[0];
    CHECK(dot(d, u) > 0);
    CHECK(dot(d, u) < 1e-14);
  }
}

TEST_CASE("event-driven: a bouncing ball rests after t1·(1 + e)/(1 − e), at a bounded number of events a second") {
  // A sphere that lies on the floor bounces for the duration of a contact each time.
  const double rest = std::sqrt(2 / 9.81) * 1.8 / 0.2, contact_duration = 1e-4;
  CHECK(rest == Approx(4.063712769).margin(1e-9));
  const Report before = world_at(dropped_ball(), rest - 0.1, contact_duration)->report();
  const Report at_rest = world_at(dropped_ball(), rest + 0.1, contact_duration)->report();
  const Report later = world_at(dropped_ball(), rest + 1.1, contact_duration)->report();
  CHECK(before.kinetic_energy + before.potential_energy - 2 * 9.81 * 0.05 > 1e-3);
  CHECK(at_rest.kinetic_energy < std::pow(9.81 * contact_duration, 2));
  CHECK(later.events - at_rest.events <= 1 / contact_duration + 1);
  CHECK(later.tally.floor_impulse - at_rest.tally.floor_impulse == Approx(2 * 9.81).epsilon(1e-4));
}

TEST_CASE(
    "event-driven: a run that cannot go on leaves a state of before the failure, with all spheres in the domain") {
  // Without the TC model the ball comes to rest at 4.0637 s by ever faster bounces.
  const double rest = std::sqrt(2 / 9.81) * 1.8 / 0.2;
  for (const double dt : {0.5, 3.0, 1000.0}) {
    Settings settings = event_driven(dt);
    settings.contact_duration = 0;
    const auto world = make_cpu_world(dropped_ball(), settings);
    CHECK_THROWS_AS(
        [&] {
          for (;;) world->step();
        }(),
        RunError);
    CHECK(world->last_good_time() == Approx(rest).epsilon(1e-6));
    CHECK(world->last_good_time() <= rest + 1e-9);
    CHECK(world->steps() == static_cast<int64_t>(rest / dt));
    const Bodies bodies = world->last_good();
    CHECK(bodies.position[0].y >= 0.05);
    CHECK(bodies.position[0].y < 0.05 + 1e-6);
    CHECK(length(bodies.velocity[0]) < 1e-3);
  }
}

TEST_CASE("event-driven: a ball that lies on the floor stays there, whatever its restitution") {
  const double e = GENERATE(0.0, 0.5, 1.0);
  Scene scene = dropped_ball();
  scene.physics.wall_restitution = e;
  scene.bodies.position[0].y = 0.05;
  const auto world = world_at(scene, 1.0, 1e-4);
  CHECK(world->bodies().position[0].y == Approx(0.05).margin(1e-7));
  CHECK(world->report().events <= 10001);
  CHECK(world->report().max_overlap < 1e-10);
}

TEST_CASE("event-driven: spheres that overlap by a millionth of a radius part and collide like others") {
  Scene scene = cradle(4, 1.0);
  for (size_t k = 2; k < 4; ++k) scene.bodies.position[k].x -= 0.5e-6 * double(k - 1);
  const auto world = world_at(scene, 4.0);
  CHECK(world->bodies().velocity[3].x == Approx(1).epsilon(1e-12));
  CHECK(world->report().tally.collisions == 3);
}

TEST_CASE("event-driven: spheres that touch and do not approach each other do not collide") {
  Scene scene = empty_box();
  const Vec3d drift(0.01, 0.02, 0.03);
  for (int k = 0; k < 8; ++k) add_sphere(scene, Vec3d(3 + k % 2, 3 + k / 2 % 2, 3 + k / 4), drift, 0.5);
  const auto world = world_at(scene, 50.0);
  CHECK(world->report().contacts == 12);
  CHECK(world->report().tally.collisions == 0);
}

TEST_CASE("event-driven: three balls in a row collapse below e = 7 − 4√3, and the TC model ends it") {
  // McNamara and Young, "Inelastic collapse and clumping in a one-dimensional granular medium" (1992),
  // doi 10.1063/1.858323: below that restitution the middle ball never stops moving to and fro.
  const auto collisions = [](double e, double contact_duration) {
    Scene scene = empty_box(100.0);
    scene.physics.restitution = e;
    add_sphere(scene, {10, 50, 50}, {1, 0, 0}, 0.5);
    add_sphere(scene, {20, 50, 50}, Vec3d(0.0), 0.5);
    add_sphere(scene, {30, 50, 50}, {-1, 0, 0}, 0.5);
    return world_at(scene, 30.0, contact_duration)->report().tally.collisions;
  };
  const double critical = 7 - 4 * std::sqrt(3.0);
  CHECK(collisions(critical - 0.03, 0.0) > 20);
  CHECK(collisions(critical + 0.03, 0.0) < 12);
  CHECK(collisions(critical - 0.03, 1e-3) < 12);
}

TEST_CASE("event-driven: spheres that stay together (e = 0) neither creep into each other nor collide without end") {
  // A head-on train of spheres that lose all relative speed, then fly on as one for ten thousand radii.
  Scene scene = empty_box(20.0);
  scene.domain.boundary = Boundary::periodic;
  scene.physics.restitution = 0;
  for (int k = 0; k < 5; ++k) add_sphere(scene, {2 + 1.5 * k, 5, 5}, {3.0 - 0.3 * k * k, 0.1, 0.2}, 0.5, 1 + 0.37 * k);
  const auto world = make_cpu_world(scene, event_driven(1000));
  for (int k = 0; k < 5; ++k) {
    world->step();
    CHECK(world->report().max_overlap < 1e-10);
    CHECK(world->report().tally.collisions < 200);
  }
}

TEST_CASE("event-driven: a million events leave no overlap and no trace in energy and momentum", "[slow]") {
  const Scene scene = make_lattice_gas(4, 0.9, 3);
  const auto world = make_cpu_world(scene, event_driven(250));
  world->step();
  const Report report = world->report();
  CHECK(report.events > 1000000);
  CHECK(report.max_overlap < 1e-10);
  CHECK(report.kinetic_energy == Approx(1.5 * double(scene.bodies.size() - 1)).epsilon(1e-11));
  CHECK(length(report.momentum) < 1e-9);
}

TEST_CASE("event-driven: spheres settle without overlap, at a bounded number of events a second") {
  Scene scene = mixed_heap();
  scene.physics.restitution = scene.physics.wall_restitution = 0.4;
  Settings settings = event_driven(0.5);
  settings.contact_duration = 1e-4;
  const auto world = make_cpu_world(scene, settings);
  Report last = world->report();
  const double energy = total_energy(last);
  for (int k = 0; k < 8; ++k) {
    world->step();
    const Report report = world->report();
    CHECK(report.max_overlap < 1e-10);
    CHECK(total_energy(report) < total_energy(last) + 1e-3);
    CHECK(double(report.events - last.events) < 2 * 60 * settings.dt / settings.contact_duration);
    last = report;
  }
  // They lie on a floor without friction, which gravity makes slide to and fro.
  CHECK(last.kinetic_energy < 0.005 * energy);
}

TEST_CASE("event-driven: without a contact duration a ball that comes to rest stops the run instead of time") {
  try {
    world_at(dropped_ball(), 5.0, 0.0);
    FAIL("ran on");
  } catch (const RunError& error) {
    CHECK_THAT(error.what(), Catch::Contains("sphere 0") && Catch::Contains("--contact-duration"));
  }
}

TEST_CASE("event-driven: collisions that come fast and end are no end of time") {
  // A light ball between a wall and one that is 10^8 times as heavy: 31 415 collisions, most of them within 10^-4 s, at
  // up to 10^4 times the speeds of the start.
  Scene scene = empty_box(4.0);
  add_sphere(scene, {0.5, 2, 2}, Vec3d(0.0), 0.1, 1.0);
  add_sphere(scene, {1.6, 2, 2}, {-1, 0, 0}, 0.3, 1e8);
  for (const double contact_duration : {0.0, 1e-6, 1e-3}) {
    const Tally tally = world_at(scene, 3.0, contact_duration)->report().tally;
    CHECK(tally.collisions + tally.wall_hits == 31415);
  }
}

TEST_CASE("event-driven: a ball that runs into a corner loses the same part of its speed at each wall") {
  const int walls = GENERATE(2, 3);
  Scene scene = empty_box(2.0);
  scene.physics.wall_restitution = 0.8;
  const Vec3d v(-1, -1, walls == 3 ? -1 : 0);
  add_sphere(scene, {0.6, 0.6, walls == 3 ? 0.6 : 1.0}, v, 0.1);
  const Vec3d after = world_at(scene, 0.6)->bodies().velocity[0];
  CHECK(length(after + 0.8 * v) < 1e-12);
}

TEST_CASE("event-driven: a ball struck by a ball and a wall at right angles at once loses energy at both") {
  Scene scene = empty_box(4.0);
  scene.physics.restitution = scene.physics.wall_restitution = 0.5;
  add_sphere(scene, {1, 1, 2}, {0, -1, 0}, 0.5, 1.0);      // reaches the floor at 0.5 s
  add_sphere(scene, {2.5, 0.5, 2}, {-1, 0, 0}, 0.5, 1.0);  // and is there at that time, beside it
  const Bodies after = world_at(scene, 0.6)->bodies();
  CHECK(length(after.velocity[0] - Vec3d(-0.75, 0.5, 0)) < 1e-6);
  CHECK(length(after.velocity[1] - Vec3d(-0.25, 0, 0)) < 1e-6);
}

TEST_CASE("event-driven: a sphere that fits exactly between two walls falls along them") {
  Scene scene;
  scene.domain.max = {1, 2, 1};
  scene.physics.gravity = {0, -9.81, 0};
  add_sphere(scene, {0.5, 1, 0.5}, {0.1, 0, 0}, 0.5);
  const auto world = world_at(scene, 0.2);
  CHECK(world->bodies().velocity[0].x == 0);
  CHECK(world->bodies().position[0].y == Approx(1 - 0.5 * 9.81 * 0.04).epsilon(1e-9));
  CHECK(world->bodies().position[0].x == Approx(0.5).margin(1e-9));
  CHECK(world_at(scene, 5.0)->bodies().position[0].y == Approx(0.5).margin(1e-3));
}

TEST_CASE("event-driven: a sphere that gravity presses between two walls without room stops the run and is named so") {
  Scene scene;
  scene.domain.max = {2, 1, 2};
  scene.physics.gravity = {0, -9.81, 0};
  add_sphere(scene, {1, 0.5, 1}, {0.1, 0, 0}, 0.5);
  try {
    world_at(scene, 1.0);
    FAIL("ran on");
  } catch (const RunError& error) {
    CHECK_THAT(error.what(), Catch::Contains("sphere 0") && Catch::Contains("fits exactly between the walls along y"));
  }
}
