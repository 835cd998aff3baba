// SPDX-License-Identifier: MIT
// Every row of the table of rules, on either side of its line.
#include "choose/rules.h"

#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "measure/theory.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

Scene box(double half = 1) {
  Scene scene;
  scene.domain = {Vec3d(-half), Vec3d(half), Boundary::walls, 3};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  return scene;
}

/// Two spheres of radius 0.1 and mass 1 in flight.
Scene pair(double speed = 1) {
  Scene scene = box();
  add_sphere(scene, {-0.5, 0, 0}, {speed, 0, 0}, 0.1);
  add_sphere(scene, {0.5, 0, 0}, {0, 0, 0}, 0.1);
  return scene;
}

/// Spheres of radius 0.1 and mass 1 upon each other, at rest on the floor.
Scene stack(int count, double top_mass = 1) {
  Scene scene = box();
  scene.domain.max.y = 10;
  scene.physics.gravity = {0, -10, 0};
  for (int k = 0; k < count; ++k) {
    add_sphere(scene, {0, -1 + 0.1 + 0.2 * k, 0}, Vec3d(0.0), 0.1, k + 1 == count ? top_mass : 1);
  }
  return scene;
}

Settings settings(Response response, double dt = 0.001) {
  Settings result;
  result.response = response;
  result.dt = dt;
  return result;
}

/// The rule's own objection.
std::string objection(std::string_view name, const Scene& scene, const Settings& s, const Needs& needs = {}) {
  const SceneNumbers numbers = numbers_of(scene);
  for (const Rule& rule : rules()) {
    if (rule.name == name) return rule.objection({scene, needs, numbers, s});
  }
  throw std::out_of_range(std::string(name));
}

Needs needing(Effect effect, double duration = 10) {
  Needs needs;
  needs.duration = duration;
  needs.effects = {effect};
  return needs;
}

Needs with_overlap(double overlap, double duration = 10) {
  Needs needs;
  needs.duration = duration;
  needs.max_overlap = overlap;
  return needs;
}

}  // namespace

TEST_CASE("rules have different names, a formula and a source") {
  std::set<std::string_view> names;
  for (const Rule& rule : rules()) {
    CHECK(names.insert(rule.name).second);
    CHECK_FALSE(rule.formula.empty());
    CHECK_FALSE(rule.source.empty());
    CHECK_FALSE(rule.methods.empty());
  }
}

TEST_CASE("kinematic motion serves only where the needs name it") {
  CHECK_FALSE(objection("plausible", pair(), settings(Response::kinematic)).empty());
  CHECK(objection("plausible", pair(), settings(Response::kinematic), needing(Effect::kinematic)).empty());
  CHECK(objection("plausible", pair(), settings(Response::impulse)).empty());
}

TEST_CASE("contacts have a duration with springs alone") {
  const Needs needs = needing(Effect::contact_time);
  for (const Response r : {Response::impulse, Response::position_based, Response::event_driven, Response::kinematic}) {
    CHECK_FALSE(objection("contact-time", pair(), settings(r), needs).empty());
    CHECK(objection("contact-time", pair(), settings(r)).empty());
  }
  CHECK(objection("contact-time", pair(), settings(Response::penalty), needs).empty());
}

TEST_CASE("a contact of springs is resolved by twenty steps") {
  const Scene scene = pair();
  const double lasts = contact_duration(scene.physics.stiffness, 0.5, 0);
  const Needs needs = needing(Effect::contact_time);
  CHECK(objection("resolved", scene, settings(Response::penalty, lasts / 20.1), needs).empty());
  CHECK_FALSE(objection("resolved", scene, settings(Response::penalty, lasts / 19.9), needs).empty());
  CHECK(objection("resolved", scene, settings(Response::penalty, lasts / 19.9)).empty());  // nobody looks at it
}

TEST_CASE("one hit after another takes exact motion") {
  const Needs needs = needing(Effect::momentum_order);
  for (const Response r : {Response::impulse, Response::position_based, Response::penalty}) {
    CHECK_FALSE(objection("order", pair(), settings(r), needs).empty());
  }
  CHECK(objection("order", pair(), settings(Response::event_driven), needs).empty());
}

TEST_CASE("exact motion cannot serve once contacts last") {
  Scene ball = box();
  ball.physics.gravity = {0, -10, 0};
  ball.physics.restitution = ball.physics.wall_restitution = 0.5;
  add_sphere(ball, {0, 0.1, 0}, Vec3d(0.0), 0.1);
  // It falls 1 m in 0.447 s, and rests after (1 + e)/(1 − e) times as long.
  const double rest = std::sqrt(2 * 1.0 / 10) * 3;
  CHECK(numbers_of(ball).rest_time == Approx(rest));
  Needs needs;
  needs.duration = 0.99 * rest;
  CHECK(objection("lasting-contacts", ball, settings(Response::event_driven), needs).empty());
  needs.duration = 1.01 * rest;
  CHECK_FALSE(objection("lasting-contacts", ball, settings(Response::event_driven), needs).empty());
  ball.physics.restitution = ball.physics.wall_restitution = 1;
  CHECK(objection("lasting-contacts", ball, settings(Response::event_driven), needs).empty());
  CHECK_FALSE(objection("lasting-contacts", ball, settings(Response::event_driven), needing(Effect::resting)).empty());
}

TEST_CASE("hard spheres may not overlap at the start") {
  Scene scene = box();
  add_sphere(scene, {0, 0, 0}, Vec3d(0.0), 0.1);
  add_sphere(scene, {0.2 - 2e-8, 0, 0}, Vec3d(0.0), 0.1);
  CHECK(objection("overlap", scene, settings(Response::event_driven)).empty());
  scene.bodies.position[1].x = 0.2 - 2e-6;
  CHECK_FALSE(objection("overlap", scene, settings(Response::event_driven)).empty());
  CHECK(objection("overlap", scene, settings(Response::impulse)).empty());
}

TEST_CASE("springs are too soft if the weight above presses them too far") {
  Scene scene = stack(5);
  scene.physics.stiffness = 5 * 1 * 10 / (0.01 * 0.1);  // n·m·g/k is a hundredth of the radius
  CHECK(objection("soft", scene, settings(Response::penalty), with_overlap(0.0101)).empty());
  CHECK_FALSE(objection("soft", scene, settings(Response::penalty), with_overlap(0.0099)).empty());
}

TEST_CASE("paths are lost to chaos after half of the collisions that the precision can follow") {
  Scene gas = make_cloud({.count = 200, .smallest = 0.05, .largest = 0.05}, 3);
  gas.physics.restitution = 1;
  const double rate = numbers_of(gas).collision_rate;
  REQUIRE(rate > 0);
  Settings s = settings(Response::impulse);
  CHECK(objection("chaos", gas, s, needing(Effect::paths, 10.4 / rate)).empty());
  CHECK_FALSE(objection("chaos", gas, s, needing(Effect::paths, 10.6 / rate)).empty());
  s.precision = Precision::float64;
  CHECK(objection("chaos", gas, s, needing(Effect::paths, 22.9 / rate)).empty());
  CHECK_FALSE(objection("chaos", gas, s, needing(Effect::paths, 23.1 / rate)).empty());
}

TEST_CASE("cells smaller than a diameter miss contacts") {
  Settings s = settings(Response::impulse);
  s.cell_size = 0.9;
  CHECK_THAT(objection("cells", pair(), s), Catch::Contains("98.3 %"));
  s.cell_size = 1;
  CHECK(objection("cells", pair(), s).empty());
}

TEST_CASE("springs gain energy from steps above 0.7071·√(m/k)") {
  const Scene scene = pair();  // m = 1 kg, k = 1e5 N/m
  const double limit = 0.70710678 * std::sqrt(1 / 1e5);
  CHECK(objection("stable-step", scene, settings(Response::penalty, 0.99 * limit)).empty());
  CHECK_THAT(objection("stable-step", scene, settings(Response::penalty, 5 * limit)), Catch::Contains("5.00 times"));
  CHECK(objection("stable-step", scene, settings(Response::impulse, 5 * limit)).empty());
  Settings substeps = settings(Response::penalty, 5 * limit);
  substeps.substeps = 6;
  CHECK(objection("stable-step", scene, substeps).empty());
}

TEST_CASE("a sphere that moves more than a diameter in a step may pass through another one") {
  const Scene scene = pair(10);  // D = 0.2 m
  CHECK(objection("tunnelling", scene, settings(Response::impulse, 0.0199)).empty());
  CHECK_FALSE(objection("tunnelling", scene, settings(Response::impulse, 0.0201)).empty());
  Settings swept = settings(Response::impulse, 0.0201);
  swept.is_swept = true;
  CHECK(objection("tunnelling", scene, swept).empty());
  CHECK(objection("tunnelling", scene, settings(Response::event_driven, 1)).empty());
}

TEST_CASE("far from the origin single precision loses a small step") {
  Scene scene = pair(0.2);
  const Vec3d far(65536, 0, 0);
  scene.domain.min += far;
  scene.domain.max += far;
  for (Vec3d& p : scene.bodies.position) p += far;
  Settings s = settings(Response::impulse, 1 / 60.0);  // 0.0024 m of an RMS speed; half an ulp is 0.0039 m
  CHECK_FALSE(objection("frozen", scene, s).empty());
  s.precision = Precision::float64;
  CHECK(objection("frozen", scene, s).empty());
  CHECK(objection("frozen", pair(0.2), settings(Response::impulse, 1 / 60.0)).empty());
}

TEST_CASE("single precision rounds energy as a random walk of its steps") {
  Needs needs;
  needs.energy_tolerance = 6e-8 * 100 * 1.01;  // ten thousand steps
  CHECK(objection("rounding", pair(), settings(Response::impulse, 0.001), needs).empty());
  needs.energy_tolerance = 6e-8 * 100 * 0.99;
  CHECK_FALSE(objection("rounding", pair(), settings(Response::impulse, 0.001), needs).empty());
  CHECK(objection("rounding", pair(), settings(Response::event_driven, 0.001), needs).empty());  // double precision
}

TEST_CASE("late contacts change the pressure by 3η·Z′·√π/2 of a step") {
  // ρ = 0.5, diameter 1, kT = m = 1: dZ/dt is about 11.56, of Z = 3.26.
  Scene gas;
  gas.domain = {Vec3d(0.0), Vec3d(10.0), Boundary::periodic, 3};
  gas.physics.restitution = 1;
  for (int k = 0; k < 500; ++k) add_sphere(gas, {k % 10, k / 10 % 10, k / 100 * 2 + 0.5}, {std::sqrt(3.0), 0, 0}, 0.5);
  const double step = 0.001;
  Needs needs;
  needs.observables = {{"compressibility", 11.56 * step / 3.2624 * 1.02, ""}};
  CHECK(objection("late-contacts", gas, settings(Response::impulse, step), needs).empty());
  needs.observables[0].tolerance *= 0.96;
  CHECK_FALSE(objection("late-contacts", gas, settings(Response::impulse, step), needs).empty());
  CHECK(objection("late-contacts", gas, settings(Response::event_driven, step), needs).empty());
}

TEST_CASE("a stack of n needs 7.46·n² sweeps of Jacobi, a quarter of it by Gauss-Seidel") {
  const Needs needs = with_overlap(0.01);
  const auto sinks = [](int n, int iterations, double h) {
    return 4 * stack_sweeps(n) / iterations * 10 * h * h / 0.1;
  };
  Settings s = settings(Response::impulse);
  const double limit = s.dt * std::sqrt(0.01 / sinks(10, 4, s.dt));
  s.dt = 0.99 * limit;
  CHECK(objection("tall-stack", stack(10), s, needs).empty());
  s.dt = 1.01 * limit;
  CHECK_FALSE(objection("tall-stack", stack(10), s, needs).empty());
  CHECK(objection("tall-stack", stack(9), s, needs).empty());
  s.solver = Solver::gauss_seidel;
  s.dt = 1.99 * limit;
  CHECK(objection("tall-stack", stack(10), s, needs).empty());
}

TEST_CASE("a sphere R times as heavy as what carries it needs 4.6·(R + 1) sweeps") {
  const Needs needs = with_overlap(0.01);
  const double limit = std::sqrt(0.01 * 0.1 / 10 / (ratio_sweeps(100) / 4));
  CHECK(objection("mass-ratio", stack(2, 100), settings(Response::impulse, 0.99 * limit), needs).empty());
  CHECK_FALSE(objection("mass-ratio", stack(2, 100), settings(Response::impulse, 1.01 * limit), needs).empty());
  CHECK(objection("mass-ratio", stack(2, 1), settings(Response::impulse, 1.01 * limit), needs).empty());
}

TEST_CASE("impulses leave an overlap of a hundredth of a radius in what rests") {
  Settings s = settings(Response::impulse);
  CHECK(objection("slop", stack(5), s, with_overlap(0.0101)).empty());
  CHECK_FALSE(objection("slop", stack(5), s, with_overlap(0.0099)).empty());
  CHECK(objection("slop", pair(), s, with_overlap(0.0099)).empty());  // nothing rests
  s.correction = Correction::surface;
  CHECK(objection("slop", stack(5), s, with_overlap(0.0099)).empty());
}

TEST_CASE("position-based stacks sag by (n − 1)·g·h²") {
  const double limit = std::sqrt(0.001 * 0.1 / (9 * 10));
  CHECK(objection("sag", stack(10), settings(Response::position_based, 0.99 * limit), with_overlap(0.001)).empty());
  CHECK_FALSE(
      objection("sag", stack(10), settings(Response::position_based, 1.01 * limit), with_overlap(0.001)).empty());
}

TEST_CASE("in a step a sphere enters another one by its speed") {
  const Scene scene = pair(1);  // RMS √½ m/s
  const double limit = 0.05 * 0.1 / std::sqrt(0.5);
  CHECK(objection("depth", scene, settings(Response::impulse, 0.99 * limit), with_overlap(0.05)).empty());
  CHECK_FALSE(objection("depth", scene, settings(Response::impulse, 1.01 * limit), with_overlap(0.05)).empty());
}

TEST_CASE("a run is warned of where its step cannot work, and not else") {
  const Scene scene = pair(10);
  CHECK(warnings_of(scene, settings(Response::impulse, 0.001)).empty());
  CHECK(warnings_of(scene, settings(Response::impulse, 0.1)).size() == 1);
  CHECK(warnings_of(scene, settings(Response::penalty, 0.1)).size() == 2);
}
