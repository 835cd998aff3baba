// SPDX-License-Identifier: MIT
#include "world/observer.h"

#include <catch2/catch.hpp>

#include "tests/support/hard_sphere_gas.h"

using namespace ballpit;

namespace {

double value_of(std::string_view name, const Observation& observation) {
  for (const Observable& observable : observables()) {
    if (observable.name == name) return measure(observable, observation).at(0);
  }
  throw std::runtime_error("no observable " + std::string(name));
}

/// Two spheres in a periodic square of 1 m that fly apart and never meet, at 0.3 m/s each.
Scene flights() {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(1, 1, 0), Boundary::periodic, 2};
  add_sphere(scene, {0.25, 0.25, 0}, {0.3, 0, 0}, 0.01);
  add_sphere(scene, {0.75, 0.75, 0}, {-0.3, 0, 0}, 0.01);
  return scene;
}

Observation observe(World& world, const Scene& scene, double from, double until) {
  Observer observer(scene.domain, from, true);
  observer.look(world);
  while (world.time() < until - 1e-9) {
    world.step();
    observer.look(world);
  }
  return observer.observation(world, world.report());
}

}  // namespace

TEST_CASE("ways go on across the border of a periodic domain, as often as it is crossed") {
  const Scene scene = flights();
  const auto world = make_cpu_world(scene, event_driven_gas(0.1));
  const Observation seen = observe(*world, scene, 0, 20);
  REQUIRE(seen.ways.size() == 2);
  CHECK(seen.ways[0].x == Approx(6));
  CHECK(seen.ways[1].x == Approx(-6));
  CHECK(seen.report.time == Approx(20));
  CHECK(value_of("diffusion", seen) == Approx(6.0 * 6.0 / (2 * 2 * 20)));
}

TEST_CASE("an observation that begins later counts only what comes after") {
  const Scene scene = flights();
  const auto world = make_cpu_world(scene, event_driven_gas(0.1));
  const Observation seen = observe(*world, scene, 5, 20);
  CHECK(seen.report.time == Approx(15));
  CHECK(seen.ways[0].x == Approx(4.5));
}

TEST_CASE("an observation that begins later counts only the collisions and the hits of walls after that") {
  // Two balls that swap velocities at 0.8, 4.0 and 7.2 s, and hit a wall each at 2.4 and 5.6 s.
  Scene scene;
  scene.domain.max = {2, 1, 1};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  add_sphere(scene, {0.5, 0.5, 0.5}, {0.5, 0, 0}, 0.1);
  add_sphere(scene, {1.5, 0.5, 0.5}, {-0.5, 0, 0}, 0.1);
  const std::string response = GENERATE("event-driven", "impulse", "penalty", "position-based");
  Settings settings = event_driven_gas(1e-3);
  settings.response = named<Response>(response);
  settings.keeps_tally = true;
  const auto count = [&](double from) {
    const auto world = make_cpu_world(scene, settings);
    return value_of("collisions", observe(*world, scene, from, 7.5));
  };
  INFO(response);
  CHECK(count(0) == 3 + 4);
  CHECK(count(2) == 2 + 4);
  CHECK(count(3) == 2 + 2);
}

TEST_CASE("the centre of mass does not diffuse, and within walls nothing is said") {
  Scene scene = flights();
  scene.bodies.velocity[1] = scene.bodies.velocity[0];
  const auto world = make_cpu_world(scene, event_driven_gas(0.1));
  Observation seen = observe(*world, scene, 0, 10);
  CHECK(value_of("diffusion", seen) == Approx(0).margin(1e-12));
  seen.domain.boundary = Boundary::walls;
  CHECK_THROWS_AS(value_of("diffusion", seen), std::out_of_range);
}

TEST_CASE("hard spheres have the mean free time and the diffusion of the literature", "[slow]") {
  // ρ = 0.5, N = 1372; diameter, mass and kT are 1. The mean free time is 0.13031 in DynamO's regression test (bounds of
  // 1 %), which agrees with 1/Γ = √π/(6·(Z − 1)) = 0.1302 for Z = 3.2694; D = 0.247 (bounds of 6 %: Lue, Collision
  // statistics, thermodynamics, and transport coefficients of hard hyperspheres, 2005, doi 10.1063/1.1834498).
  const Scene scene = make_lattice_gas(7, 0.5, 3);
  const auto world = make_cpu_world(scene, event_driven_gas(0.25));
  const Observation seen = observe(*world, scene, 5, 25);  // its speeds are those of Maxwell after 38 collisions each
  CHECK(value_of("mean-free-time", seen) == Approx(0.13031).epsilon(0.01));
  CHECK(value_of("diffusion", seen) == Approx(0.247).epsilon(0.06));
}
