// SPDX-License-Identifier: MIT
#include "choose/pilot.h"

#include <chrono>
#include <cmath>

#include <catch2/catch.hpp>

#include "core/interrupt.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

Scene crowd(Boundary boundary) {
  Scene scene = make_crowd(3, 16, boundary, 1, 0.05, 0.06);
  scene.domain.max.y = 2 * scene.domain.max.y;
  return scene;
}

double density(const Scene& scene) {
  const Vec3d size = scene.domain.max - scene.domain.min;
  return double(scene.bodies.size()) / (size.x * size.y * size.z);
}

Settings impulses(double dt) {
  Settings settings;
  settings.dt = dt;
  settings.threads = 1;
  return settings;
}

}  // namespace

TEST_CASE("a part of a heap is as deep as the whole, and nearly as dense") {
  const Scene whole = crowd(Boundary::walls);
  const Scene part = part_of(whole, 1000);
  CHECK(part.bodies.size() <= 1000);
  CHECK(part.bodies.size() > 600);
  CHECK(part.domain.max.y == whole.domain.max.y);
  CHECK(part.domain.max.x < whole.domain.max.x);
  CHECK(part.domain.max.z < whole.domain.max.z);
  CHECK(density(part) == Approx(density(whole)).epsilon(0.3));
  for (size_t i = 0; i < part.bodies.radius.size(); ++i) {
    for (const int axis : {0, 2}) {
      CHECK(part.bodies.position[i][axis] + part.bodies.radius[i] <= part.domain.max[axis] + 1e-9);
    }
  }
}

TEST_CASE("a part of a periodic gas is cut along all axes, and nothing overlaps across its border") {
  const Scene whole = crowd(Boundary::periodic);
  const Scene part = part_of(whole, 700);
  for (int axis = 0; axis < 3; ++axis) CHECK(part.domain.max[axis] < whole.domain.max[axis]);
  const auto world = make_cpu_world(part, impulses(0.001));
  CHECK(world->report().max_overlap <= make_cpu_world(whole, impulses(0.001))->report().max_overlap);
}

TEST_CASE("a scene of few spheres is piloted whole") {
  const Scene whole = crowd(Boundary::walls);
  CHECK(part_of(whole, whole.bodies.size()).bodies.size() == whole.bodies.size());
  CHECK(part_of(Scene{}, 100).bodies.size() == 0);
}

TEST_CASE("a pilot measures what a run gives") {
  Scene scene = make_crowd(3, 4, Boundary::periodic, 1, 0.05, 0.05);
  Needs needs;
  needs.duration = 0.5;
  needs.max_overlap = 1;
  needs.energy_tolerance = 1;
  const Settings settings = impulses(0.005);
  const PilotResult result = run_pilot({scene, needs, {}, 0.5, 10}, settings);
  REQUIRE(result.is_complete);
  const auto world = make_cpu_world(scene, settings);
  const double before = world->report().kinetic_energy;
  for (int k = 0; k < 100; ++k) world->step();
  CHECK(result.end_overlap == world->report().max_overlap);
  CHECK(result.errors[1] == Approx(std::fabs(world->report().kinetic_energy / before - 1)));
  CHECK(result.cost > 0);
  CHECK(result.middle.size() == scene.bodies.size());
}

TEST_CASE("a pilot that ends early scales what grows, and cannot show what comes to rest later") {
  Scene scene = make_crowd(3, 4, Boundary::walls, 0.5, 0.05, 0.05);
  Needs needs;
  needs.duration = 10;
  needs.energy_tolerance = 1;
  needs.max_speed = 0.001;
  const PilotResult early = run_pilot({scene, needs, {}, 0.1, 10}, impulses(0.005));
  CHECK_FALSE(early.is_complete);
  CHECK(early.is_at_truth);
  Needs shorter = needs;
  shorter.duration = 0.1;
  const PilotResult whole = run_pilot({scene, shorter, {}, 0.1, 10}, impulses(0.005));
  CHECK(early.errors[0] == Approx(100 * whole.errors[0]));
  CHECK(early.is_unseen[1]);
  CHECK_FALSE(whole.is_unseen[1]);
  CHECK_FALSE(holds(whole, tolerances_of(shorter), 1));
}

TEST_CASE("a run that is stopped holds nothing, and says why") {
  Scene scene = make_crowd(3, 4, Boundary::walls, 1, 0.05, 0.05);
  scene.physics.stiffness = 1e9;
  Needs needs;
  needs.duration = 10;
  Settings settings = impulses(0.01);
  settings.response = Response::penalty;
  const PilotResult result = run_pilot({scene, needs, {}, 10, 10}, settings);
  CHECK_FALSE(result.stopped.empty());
  CHECK_FALSE(holds(result, tolerances_of(needs), 1));
}

TEST_CASE("a pilot that costs more than the dearest allowed is given up") {
  Scene scene = make_crowd(3, 8, Boundary::periodic, 1, 0.05, 0.05);
  Needs needs;
  needs.duration = 10;
  const PilotResult result = run_pilot({scene, needs, {}, 10, 10, 1e-6}, impulses(0.005));
  CHECK(result.is_given_up);
  CHECK(result.reached < 5);
  CHECK_FALSE(holds(result, {}, 1));
}

TEST_CASE("exact motion among lasting contacts ends a pilot in time") {
  Scene scene;
  scene.domain.max = {1, 2, 1};
  scene.physics.gravity = {0, -10, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 0.1;
  for (int k = 0; k < 5; ++k) add_sphere(scene, {0.5, 0.1 + 0.25 * k, 0.5}, Vec3d(0.0), 0.1);
  Needs needs;
  needs.duration = 1000;
  Settings settings = impulses(1000);
  settings.response = Response::event_driven;
  const auto start = std::chrono::steady_clock::now();
  const PilotResult result = run_pilot({scene, needs, {}, 1000, 0.1}, settings);
  CHECK_FALSE(result.is_complete);
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 5);
}

TEST_CASE("a pilot sees the largest overlap and the largest change of energy of its run, needed or not") {
  Scene scene = make_crowd(3, 4, Boundary::periodic, 0.5, 0.05, 0.05);
  Needs needs;
  needs.duration = 0.5;
  const PilotResult result = run_pilot({scene, needs, {}, 0.5, 10}, impulses(0.005));
  const auto world = make_cpu_world(scene, impulses(0.005));
  const double before = world->report().kinetic_energy;
  double overlap = 0, drift = 0;
  for (int k = 0; k < 100; ++k) {
    world->step();
    overlap = std::max(overlap, world->report().max_overlap);
    drift = std::max(drift, std::fabs(world->report().kinetic_energy / before - 1));
  }
  CHECK(result.seen.overlap <= overlap);
  CHECK(result.seen.overlap > 0.5 * overlap);
  CHECK(result.seen.drift == Approx(drift).epsilon(0.05));
}

TEST_CASE("a pilot that is asked to stop makes no step") {
  Scene scene = make_crowd(3, 4, Boundary::periodic, 1, 0.05, 0.05);
  Needs needs;
  needs.duration = 0.5;
  std::stop_source source;
  const PilotPlan plan{.scene = scene, .needs = needs, .truth = {}, .until = 0.5, .stop = source.get_token()};
  CHECK_NOTHROW(run_pilot(plan, impulses(0.005)));
  source.request_stop();
  CHECK_THROWS_AS(run_pilot(plan, impulses(0.005)), Interrupted);
}
