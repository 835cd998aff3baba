// SPDX-License-Identifier: MIT
#include "choose/numbers.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "measure/theory.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

Scene gas(double rho, int side) {
  Scene scene;
  const double pitch = std::cbrt(1 / rho);
  scene.domain = {Vec3d(0.0), Vec3d(side * pitch), Boundary::periodic, 3};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  for (int k = 0; k < side * side * side; ++k) {
    const double v = k % 2 == 0 ? 1 : -1;  // kT = 1: ⟨v²⟩ = 3
    add_sphere(scene, pitch * (Vec3d(k % side, k / side % side, k / side / side) + 0.5), Vec3d(v), 0.5);
  }
  return scene;
}

}  // namespace

TEST_CASE("a gas has the packing and the collision rate of kinetic theory") {
  for (const double rho : {0.1, 0.3, 0.5}) {
    const SceneNumbers n = numbers_of(gas(rho, 8));
    CHECK(n.packing == Approx(rho * M_PI / 6));
    CHECK(n.typical_speed == Approx(std::sqrt(3.0)));
    CHECK(n.collision_rate == Approx(collision_rate(rho, 1e6)).epsilon(0.01));
    CHECK(n.layers == 1);
    CHECK(n.rest_time == INFINITY);
    CHECK_FALSE(n.loses_energy);
  }
}

TEST_CASE("numbers do not depend on the order of spheres, nor pure ones on units") {
  Scene scene = make_crowd(3, 5, Boundary::walls, 0.5, 0.03, 0.06);
  const SceneNumbers n = numbers_of(scene);
  std::ranges::reverse(scene.bodies.position);
  std::ranges::reverse(scene.bodies.velocity);
  std::ranges::reverse(scene.bodies.radius);
  std::ranges::reverse(scene.bodies.mass);
  const double length = 1e3, time = 1e-2, mass = 10;
  const auto scale = [](auto& values, double factor) {
    for (auto& value : values) value *= factor;
  };
  scale(scene.bodies.position, length);
  scale(scene.bodies.velocity, length / time);
  scale(scene.bodies.radius, length);
  scale(scene.bodies.mass, mass);
  scene.domain.min *= length;
  scene.domain.max *= length;
  scene.physics.gravity *= length / time / time;
  scene.physics.stiffness *= mass / time / time;
  const SceneNumbers other = numbers_of(scene);
  CHECK(other.packing == Approx(n.packing));
  CHECK(other.layers == Approx(n.layers));
  CHECK(other.size_ratio() == Approx(n.size_ratio()));
  CHECK(other.mass_ratio() == Approx(n.mass_ratio()));
  CHECK(other.flight(0.01 * time) == Approx(n.flight(0.01)));
  CHECK(other.collision_rate * time == Approx(n.collision_rate));
  CHECK(other.contact_duration / time == Approx(n.contact_duration));
  CHECK(other.rest_time / time == Approx(n.rest_time));
}

TEST_CASE("a tower has as many layers as spheres, and those at rest do not fall") {
  Scene scene;
  scene.domain = {Vec3d(-1.0), Vec3d(1, 9, 1), Boundary::walls, 3};
  scene.physics.gravity = {0, -10, 0};
  for (int k = 0; k < 12; ++k) add_sphere(scene, {0, -0.9 + 0.2 * k, 0}, Vec3d(0.0), 0.1);
  const SceneNumbers n = numbers_of(scene);
  CHECK(n.layers == 12);
  CHECK(n.typical_speed == 0);
  CHECK(n.is_planar_motion);
  add_sphere(scene, {0.5, 4.1, 0}, Vec3d(0.0), 0.1);
  CHECK(numbers_of(scene).largest_speed == Approx(std::sqrt(2 * 10 * 5.0)));
  scene.bodies.position[12].z = 0.1;
  CHECK_FALSE(numbers_of(scene).is_planar_motion);
}

TEST_CASE("a chain counts through a heap in any order of spheres, and sideways contacts do not") {
  Scene scene;
  scene.domain = {Vec3d(-1.0), Vec3d(1, 9, 1), Boundary::walls, 3};
  scene.physics.gravity = {0, -10, 0};
  for (const int k : {2, 0, 1}) add_sphere(scene, {0, -0.9 + 0.2 * k, 0}, Vec3d(0.0), 0.1);
  add_sphere(scene, {0.2, -0.9, 0}, Vec3d(0.0), 0.1);
  CHECK(numbers_of(scene).layers == 3);
}

TEST_CASE("scenes without spheres, and of one sphere, have numbers") {
  Scene scene;
  CHECK(numbers_of(scene).count == 0);
  add_sphere(scene, Vec3d(0.5), {1, 0, 0}, 0.1);
  const SceneNumbers n = numbers_of(scene);
  CHECK(n.collision_rate == 0);
  CHECK(n.flight(0.1) == Approx(0.5));
  for (const NamedNumber& number : named_numbers(n, 0.1)) CHECK_FALSE(std::isnan(number.value));
}

TEST_CASE("the largest overlap at the start is that of the deepest pair") {
  Scene scene;
  add_sphere(scene, {0.3, 0.5, 0.5}, Vec3d(0.0), 0.1);
  add_sphere(scene, {0.45, 0.5, 0.5}, Vec3d(0.0), 0.1);
  CHECK(numbers_of(scene).start_overlap == Approx(0.5));
}

TEST_CASE("Hertz's springs are as stiff as at the overlap of a typical hit") {
  Scene scene = gas(0.3, 3);
  scene.physics.law = "hertz";
  scene.physics.stiffness = 1e6;
  const SceneNumbers n = numbers_of(scene);
  const double overlap = std::pow(5 * 0.5 * 3 / (4e6), 0.4);
  CHECK(stable_step(scene, n) == Approx(0.70710678 * std::sqrt(1 / (1.5e6 * std::sqrt(overlap)))));
  CHECK(n.contact_duration == Approx(hertz_duration(1e6, 0.5, std::sqrt(3.0))));
}
