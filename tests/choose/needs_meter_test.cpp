// SPDX-License-Identifier: MIT
#include "choose/needs_meter.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "scene/read_scene.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// One sphere of mass 2 that flies freely at 1 m/s along x.
Scene flight() {
  Scene scene;
  scene.domain = {Vec3d(-5.0), Vec3d(5.0), Boundary::walls, 3};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  add_sphere(scene, Vec3d(0.0), {1, 0, 0}, 0.1, 2);
  return scene;
}

Settings quarters() {
  Settings settings;
  settings.dt = 0.25;
  settings.precision = Precision::float64;
  return settings;
}

}  // namespace

TEST_CASE("tolerances are those that the scene names, in the order of the table") {
  Needs needs;
  CHECK(tolerances_of(needs).empty());
  needs.max_speed = 0.1;
  needs.max_overlap = 0.2;
  needs.observables = {{"pressure", 0.05, ""}};
  const std::vector<Tolerance> tolerances = tolerances_of(needs);
  REQUIRE(tolerances.size() == 3);
  CHECK(tolerances[0].name == "max_overlap");
  CHECK(tolerances[1].name == "max_speed");
  CHECK(tolerances[1].allowed == 0.1);
  CHECK(tolerances[2].name == "pressure");
}

TEST_CASE("a scene without [needs] gets defaults, and a note that says so") {
  Scene scene = flight();
  const EffectiveNeeds elastic = effective_needs(scene);
  CHECK_THAT(elastic.note, Catch::Contains("duration = 10") && Catch::Contains("energy_tolerance"));
  CHECK(elastic.needs.energy_tolerance == 0.01);
  scene.physics.restitution = 0.5;
  CHECK_FALSE(effective_needs(scene).needs.energy_tolerance);
  scene.needs.are_declared = true;
  CHECK(effective_needs(scene).note.empty());
  CHECK_FALSE(effective_needs(scene).needs.max_overlap);
  scene.needs.effects = {Effect::paths};
  CHECK(effective_needs(scene).needs.path_tolerance == 0.1);
}

TEST_CASE("the distance from the true path is the median in radii, also at another time and across a border") {
  Scene scene = flight();
  Needs needs;
  needs.path_tolerance = 1;
  const auto world = make_cpu_world(scene, quarters());
  const NeedsMeter meter(scene, needs, *world);
  world->step();  // x = 0.25
  const auto off = [&](const Truth& truth) { return meter.errors(*world, truth).at(0); };
  CHECK(off({0.25, {{0.25, 0, 0}}, {{1, 0, 0}}, {}}) == Approx(0).margin(1e-12));
  CHECK(off({0.25, {{0.25, 0.02, 0}}, {{1, 0, 0}}, {}}) == Approx(0.2));
  CHECK(off({0.2, {{0.2, 0, 0}}, {{1, 0, 0}}, {}}) == Approx(0).margin(1e-12));
  CHECK(std::isnan(off({})));

  scene.domain.boundary = Boundary::periodic;
  const auto periodic = make_cpu_world(scene, quarters());
  const NeedsMeter around(scene, needs, *periodic);
  periodic->step();
  CHECK(around.errors(*periodic, {0.25, {{-9.75, 0, 0}}, {{1, 0, 0}}, {}}).at(0) == Approx(0).margin(1e-12));
}

TEST_CASE("energy is measured above the bottom of the domain, wherever the origin is") {
  Scene scene = flight();
  scene.physics.gravity = {0, -10, 0};
  scene.bodies.velocity[0] = Vec3d(0.0);
  scene.bodies.position[0].y = -4.9;  // lies on the floor: 2 kg · 10 m/s² · 0.1 m above the bottom
  Needs needs;
  needs.energy_tolerance = 1;
  const auto world = make_cpu_world(scene, quarters());
  const NeedsMeter meter(scene, needs, *world);
  scene.bodies.velocity[0] = {1, 0, 0};  // 1 J more, of 2 J
  const auto faster = make_cpu_world(scene, quarters());
  CHECK(meter.errors(*faster, {}).at(0) == Approx(0.5));
}

TEST_CASE("momentum is compared with the sum of all at the start") {
  Scene scene = flight();
  add_sphere(scene, {2, 0, 0}, {-1, 0, 0}, 0.1, 2);
  Needs needs;
  needs.momentum_tolerance = 1;
  const auto world = make_cpu_world(scene, quarters());
  const NeedsMeter meter(scene, needs, *world);
  scene.bodies.velocity[0] = {2, 0, 0};  // 2 kg·m/s more; Σ m·|v₀| is 4
  CHECK(meter.errors(*make_cpu_world(scene, quarters()), {}).at(0) == Approx(0.5));
}

TEST_CASE("the largest overlap of a run is remembered") {
  Scene scene = flight();
  scene.bodies.velocity[0] = Vec3d(0.0);
  add_sphere(scene, {0.15, 0, 0}, Vec3d(0.0), 0.1, 2);
  Needs needs;
  needs.max_overlap = 1;
  needs.max_overlap_ever = 1;
  const auto world = make_cpu_world(scene, quarters());
  NeedsMeter meter(scene, needs, *world);
  for (int k = 0; k < 20; ++k) {
    world->step();
    meter.look(*world);
  }
  const std::vector<double> errors = meter.errors(*world, {});
  CHECK(errors[0] < 0.1);
  CHECK(errors[1] == Approx(0.5));
}

TEST_CASE("an observable is compared with its true value") {
  Scene scene = flight();
  Needs needs;
  needs.observables = {{"kinetic-energy", 0.1, ""}, {"momentum", 0.1, ""}, {"pressure", 0.1, ""}};
  CHECK(need_tally(needs));
  const auto world = make_cpu_world(scene, quarters());
  const NeedsMeter meter(scene, needs, *world);
  const std::vector<double> errors = meter.errors(*world, {0, {}, {}, {{1.25}, {2, 1.5, 0}, {}}});
  CHECK(errors[0] == Approx(0.2));        // 1 J of 1.25 J
  CHECK(errors[1] == Approx(1.5 / 2.5));  // (2, 0, 0) and (2, 1.5, 0)
  CHECK(std::isnan(errors[2]));
}

TEST_CASE("an observable that does not exist is named with its place") {
  const Scene scene = parse_scene("[needs.observables]\nzeal = 0.1\n[domain]\n", "a.toml");
  CHECK_THROWS_WITH(check_observables(scene.needs),
                    Catch::Contains("a.toml:2: [needs.observables] zeal: found zeal, allowed kinetic-energy"));
}
