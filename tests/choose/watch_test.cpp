// SPDX-License-Identifier: MIT
#include "choose/watch.h"

#include <catch2/catch.hpp>

#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// Two spheres that meet after 0.3 s.
Scene approaching_pair() {
  Scene scene;
  scene.domain = {Vec3d(-1.0), Vec3d(1.0), Boundary::walls, 3};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  add_sphere(scene, {-0.25, 0, 0}, {1, 0, 0}, 0.1);
  add_sphere(scene, {0.25, 0, 0}, {0, 0, 0}, 0.1);
  return scene;
}

Choice choice_with(const Needs& needs, const Settings& settings) {
  Choice choice;
  choice.needs.needs = needs;
  choice.tolerances = tolerances_of(needs);
  choice.numbers = numbers_of(approaching_pair());
  choice.chosen = Attempt{"impulse", settings};
  Settings finer = settings;
  finer.dt /= 2;
  choice.dearer = {finer};
  return choice;
}

Settings impulses_of(double dt) {
  Settings settings;
  settings.dt = dt;
  return settings;
}

}  // namespace

TEST_CASE("a breach of overlap is seen during the run, and the last good state comes back") {
  Needs needs;
  needs.max_overlap_ever = 0.05;
  const Settings settings = impulses_of(0.08);
  const auto world = make_cpu_world(approaching_pair(), settings);
  Watch watch(approaching_pair(), choice_with(needs, settings), *world);
  std::string breach;
  for (int k = 0; k < 10 && breach.empty(); ++k) {
    const uint64_t good = world->report().state_hash;
    world->step();
    breach = watch.breach(*world, settings);
    if (breach.empty()) {
      watch.accept(*world);
    } else {
      watch.go_back(*world);
      CHECK(world->report().state_hash == good);
    }
  }
  CHECK_THAT(breach, Catch::Contains("max_overlap_ever") && Catch::Contains("allowed 0.050"));
  const std::optional<Settings> next = watch.next();
  REQUIRE(next);
  CHECK(next->dt == 0.04);
  CHECK_FALSE(watch.next());
}

TEST_CASE("what counts at the end is not a breach before it") {
  Needs needs;
  needs.duration = 1;
  needs.max_speed = 0.1;
  const Settings settings = impulses_of(0.01);
  const auto world = make_cpu_world(approaching_pair(), settings);
  const Watch watch(approaching_pair(), choice_with(needs, settings), *world);
  for (int k = 0; k < 99; ++k) world->step();
  CHECK(watch.breach(*world, settings).empty());
  world->step();
  CHECK_THAT(watch.breach(*world, settings), Catch::Contains("max_speed"));
}

TEST_CASE(
    "overlap that counts at the end may be twice that of the pilot before, and more where nothing dearer is left") {
  Needs needs;
  needs.duration = 100;
  needs.max_overlap = 0.01;
  const Settings settings = impulses_of(0.08);
  Choice choice = choice_with(needs, settings);
  choice.chosen->largest_overlap = 0.2;
  Scene scene = approaching_pair();
  const auto apart = make_cpu_world(scene, settings);
  Watch watch(scene, choice, *apart);
  const auto breach_at = [&](double overlap) {
    scene.bodies.position[1].x = scene.bodies.position[0].x + 0.2 - 0.1 * overlap;
    return watch.breach(*make_cpu_world(scene, settings), settings);
  };
  CHECK(breach_at(0.39) == "");
  CHECK_THAT(breach_at(0.41), Catch::Contains("max_overlap"));
  CHECK(watch.next());
  CHECK(breach_at(0.41).empty());
}

TEST_CASE("a sphere that became too fast for the step is a breach") {
  Needs needs;
  const Settings settings = impulses_of(0.01);
  Scene scene = approaching_pair();
  const auto slow = make_cpu_world(scene, settings);
  const Watch watch(scene, choice_with(needs, settings), *slow);
  CHECK(watch.breach(*slow, settings).empty());
  scene.bodies.velocity[0].x = 21;  // 1.05 diameters in a step
  const auto fast = make_cpu_world(scene, settings);
  CHECK_THAT(watch.breach(*fast, settings), Catch::Contains("1.05 diameters in a step"));
  Settings swept = settings;
  swept.is_swept = true;
  CHECK(watch.breach(*fast, swept).empty());
}

TEST_CASE("a watch looks every 128 steps") {
  const Settings settings = impulses_of(0.001);
  const auto world = make_cpu_world(approaching_pair(), settings);
  Watch watch(approaching_pair(), choice_with({}, settings), *world);
  int looks = 0;
  for (int k = 0; k < 640; ++k) {
    world->step();
    if (!watch.is_due(*world)) continue;
    ++looks;
    watch.accept(*world);
  }
  CHECK(looks == 5);
}
