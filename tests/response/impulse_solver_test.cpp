// SPDX-License-Identifier: MIT
// Convergence of the impulse response's solvers, and its ways to correct overlap.
#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/support/hard_sphere_gas.h"
#include "tests/support/hits.h"

using namespace ballpit;

namespace {

/// A stack of spheres of these masses at rest: only gravity's kick has to be resolved.
Scene stack(const std::vector<double>& masses) {
  Scene scene;
  scene.domain.max = {1, 0.1 * static_cast<double>(masses.size()) + 1, 1};
  scene.physics.gravity = {0, -10, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 0;
  for (size_t k = 0; k < masses.size(); ++k) {
    add_sphere(scene, {0.5, 0.05 + 0.1 * static_cast<double>(k) - 1e-9 * static_cast<double>(k + 1), 0.5}, Vec3d(0),
               0.05, masses[k]);
  }
  return scene;
}

/// The largest speed that remains after one step of this many iterations, as a fraction of gravity's kick.
double residual(const Scene& scene, const std::string& solver, int iterations) {
  Settings settings = settings_of("impulse", 0.01);
  settings.solver = named<Solver>(solver);
  settings.correction = Correction::none;
  settings.iterations = iterations;
  const auto world = make_cpu_world(scene, settings);
  world->step();
  double largest = 0;
  for (const Vec3d& v : world->bodies().velocity) largest = std::max(largest, std::abs(v.y));
  return largest / (10 * 0.01);
}

/// The factor by which an iteration reduces the rest, once only its slowest component remains.
double rate(const Scene& scene, const std::string& solver, int iterations) {
  return std::pow(residual(scene, solver, 2 * iterations) / residual(scene, solver, iterations), 1.0 / iterations);
}

}  // namespace

TEST_CASE("Gauss-Seidel converges in a stack of n by cos²(π/2n) a sweep") {
  const int n = GENERATE(5, 10, 20);
  const double theory = std::pow(std::cos(M_PI / (2 * n)), 2);
  const double measured = rate(stack(std::vector<double>(static_cast<size_t>(n), 1.0)), "gauss-seidel", n * n);
  CHECK((1 - measured) / (1 - theory) == Approx(1).epsilon(0.01));
}

TEST_CASE("Gauss-Seidel leaves a percent of a stack of n after about 1.866·n² sweeps") {
  // The figure holds for the error of the impulses; the error of the speeds starts at another value, by a factor near
  // 1.
  const int n = 20;
  const double left = residual(stack(std::vector<double>(n, 1.0)), "gauss-seidel", static_cast<int>(1.866 * n * n));
  CHECK(left == Approx(0.01).epsilon(0.3));
}

TEST_CASE("Jacobi with split masses converges a quarter as fast: by cos²(π/4n) an iteration") {
  // With two contacts a body, each iteration makes half of Jacobi's change: 1 − (1 − cos(π/2n))/2. The top body has one
  // contact, which makes little difference.
  const int n = GENERATE(10, 20);
  const double theory = std::pow(std::cos(M_PI / (4 * n)), 2);
  const double measured = rate(stack(std::vector<double>(static_cast<size_t>(n), 1.0)), "jacobi", 4 * n * n);
  CHECK((1 - measured) / (1 - theory) == Approx(1).epsilon(0.1));
}

TEST_CASE("Gauss-Seidel converges under a sphere R times as heavy as the one that carries it by R/(R + 1) a sweep") {
  const double ratio = GENERATE(1.0, 10.0, 100.0);
  const int iterations = static_cast<int>(3 * (ratio + 1));
  CHECK((1 - rate(stack({1, ratio}), "gauss-seidel", iterations)) * (ratio + 1) == Approx(1).epsilon(0.01));
}

TEST_CASE("Gauss-Seidel leaves a percent of a mass ratio R after 4.6·(R + 1) sweeps") {
  const double ratio = GENERATE(100.0, 300.0);
  CHECK(residual(stack({1, ratio}), "gauss-seidel", static_cast<int>(4.6 * (ratio + 1))) == Approx(0.01).epsilon(0.1));
}

TEST_CASE("a dense elastic gas gains no energy by iterations, and keeps it where they suffice") {
  const Scene gas = make_lattice_gas(4, 0.5, 1);
  const auto kept = [&](const std::string& solver, int iterations) {
    Settings settings = settings_of("impulse", 0.02);  // a seventh of the time between a sphere's collisions
    settings.solver = named<Solver>(solver);
    settings.iterations = iterations;
    const auto world = make_cpu_world(gas, settings);
    const double start = world->report().kinetic_energy;
    for (int k = 0; k < 500; ++k) world->step();
    return world->report().kinetic_energy / start;
  };
  const double jacobi_4 = kept("jacobi", 4), jacobi_16 = kept("jacobi", 16), jacobi_64 = kept("jacobi", 64);
  CHECK(jacobi_4 < jacobi_16);
  CHECK(jacobi_16 == Approx(1).margin(0.03));
  CHECK(jacobi_64 == Approx(1).margin(0.01));
  CHECK(kept("gauss-seidel", 8) == Approx(1).margin(0.01));
}

TEST_CASE(
    "without correction a ball keeps the overlap that its last bounce entered, and walls beside it change nothing") {
  const double dt = 1.0 / 60;
  for (const double width : {3.0, 1.0}) {  // of the domain, in radii and diameters of the ball: between walls or not
    Scene scene;
    scene.domain.min = {0, -2, 0};
    scene.domain.max = {width, 1, width};
    scene.physics.gravity = {0, -9.81, 0};
    scene.physics.wall_restitution = 0.5;
    add_sphere(scene, {width / 2, -0.5, width / 2}, Vec3d(0), 0.5);
    for (const char* const correction : {"none", "split", "surface"}) {
      Settings settings = settings_of("impulse", dt);
      settings.correction = named<Correction>(correction);
      const auto world = make_cpu_world(scene, settings);
      step_until(*world, 10);
      const double sunk = -1.5 - world->bodies().position[0].y;
      INFO(correction << ", " << width << " m wide: sunk by " << sunk << " m");
      CHECK((sunk > 0.001) == (std::string(correction) == "none"));
      CHECK(sunk < 9.81 * dt * dt);
    }
  }
}

TEST_CASE("pushing a ball back to the surface gains about g·v·dt/2 in its first bounce at e = 1") {
  // The mean over the part of a step at which it arrives.
  const double g = 9.81, dt = 1.0 / 240, h = 1.0, v = std::sqrt(2 * g * h);
  constexpr int kPhases = 32;
  double mean = 0;
  for (int k = 0; k < kPhases; ++k) {
    Scene scene = wide_box(5);
    scene.physics.gravity = {0, -g, 0};
    add_sphere(scene, {0, -4.9 + h + (k + 0.5) / kPhases * v * dt, 0}, Vec3d(0), 0.1);
    Settings settings = settings_of("impulse", dt);
    settings.correction = Correction::surface;
    const auto world = make_cpu_world(scene, settings);
    const auto energy = [&] {  // E − m·g·dt·v/2 is what symplectic Euler keeps in free fall
      const Report report = world->report();
      return report.kinetic_energy + report.potential_energy - 0.5 * g * dt * world->bodies().velocity[0].y;
    };
    const double before = energy();
    step_until(*world, 0.6);  // after the first bounce, before the second
    mean += (energy() - before) / kPhases;
  }
  CHECK(mean == Approx(g * v * dt / 2).epsilon(0.04));
}
