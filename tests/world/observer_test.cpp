// SPDX-License-Identifier: MIT
#include "world/observer.h"

#include <algorithm>
#include <cmath>

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

/// 4000 spheres in a periodic cube, 100 of them of diameter and mass 1, the others of half the diameter and a
/// thousandth of the mass; 1.4 spheres in a volume of 1. kT = 1 on average, the total momentum is 0. `is_equal`: each
/// species has kT = 1; else all have the speeds of one distribution, and the few heavy spheres 25 times the energy of
/// all others.
Scene binary_mixture(bool is_equal) {
  constexpr double kLightMass = 0.001;
  Scene scene = make_lattice_gas(10, 1.4, 5);
  Bodies& bodies = scene.bodies;
  for (size_t i = 0; i < bodies.mass.size(); ++i) {
    if (i % 40 == 0) continue;
    bodies.radius[i] = 0.25;
    bodies.mass[i] = kLightMass;
    if (is_equal) bodies.velocity[i] /= std::sqrt(kLightMass);
  }
  Vec3d momentum(0.0);
  double mass = 0, energy = 0;
  for (size_t i = 0; i < bodies.mass.size(); ++i) {
    momentum += bodies.mass[i] * bodies.velocity[i];
    mass += bodies.mass[i];
  }
  for (size_t i = 0; i < bodies.mass.size(); ++i) {
    const Vec3d v = bodies.velocity[i] -= momentum / mass;
    energy += 0.5 * bodies.mass[i] * dot(v, v);
  }
  for (Vec3d& v : bodies.velocity) v *= std::sqrt(1.5 * static_cast<double>(bodies.size() - 1) / energy);
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

TEST_CASE("a mixture of large and light small spheres has the mean free time of the literature", "[slow]") {
  // In equilibrium that of Enskog's theory: spheres of species i collide with those of j at the rate
  // n_j·σ_ij²·g_ij·√(8π·kT/μ_ij), with the contact values g_ij of Boublík 1970 and Mansoori et al. 1971; 1/Σ
  // x_i·rate_i.
  const Scene scene = binary_mixture(true);
  REQUIRE(std::count(scene.bodies.radius.begin(), scene.bodies.radius.end(), 0.5) == 100);
  const auto world = make_cpu_world(scene, event_driven_gas(0.25));
  const Observation seen = observe(*world, scene, 1, 3.5);  // each sphere has collided 100 times before
  CHECK(value_of("mean-free-time", seen) == Approx(0.009402).epsilon(0.01));
  CHECK(value_of("temperature", seen) == Approx(1).epsilon(1e-9));
}

TEST_CASE("a mixture that is not in equilibrium yet has the mean free time of DynamO's test", "[slow]") {
  // DynamO's regression test of this mixture has 0.0098213 with bounds of 1 %, 4 % more than in equilibrium. It gives
  // all spheres the same speeds, and observes the second million collisions. But light spheres gain little energy in
  // each: after two million they have kT = 0.97 and the heavy ones 2.3.
  const Scene scene = binary_mixture(false);
  const auto world = make_cpu_world(scene, event_driven_gas(0.025));
  const auto step_until_collisions = [&](int64_t count) {
    while (world->report().tally.collisions < count) world->step();
  };
  step_until_collisions(1'000'000);
  Observer observer(scene.domain, world->time(), false);
  observer.look(*world);
  step_until_collisions(2'000'000);
  CHECK(value_of("mean-free-time", observer.observation(*world, world->report())) == Approx(0.0098213).epsilon(0.01));
}
