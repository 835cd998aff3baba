// SPDX-License-Identifier: MIT
// What a fixed step does to the statistics of a gas of hard spheres: diameter, mass and kT are 1. Its siblings, for exact
// motion: event_driven/statistics_test.cpp; for single paths: trajectories_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/hard_sphere_gas.h"
#include "tests/support/hits.h"

using namespace ballpit;

namespace {

/// Impulses without losses, by the solver that keeps the energy of a gas best (see below).
Settings impulses(double dt, const std::string& correction, bool is_swept = false) {
  Settings settings = settings_of("impulse", dt);
  settings.broadphase = BroadPhase::sorted_grid;
  settings.solver = Solver::gauss_seidel;
  settings.correction = named<Correction>(correction);
  settings.is_swept = is_swept;
  settings.keeps_tally = true;
  return settings;
}

/// Z = 1 + W/(3·N·kT·t) in blocks of 1, with the temperature of each: it falls by some percent.
Mean measured_z(const Scene& scene, const Settings& settings, int blocks) {
  const double count = double(scene.bodies.size());
  const auto world = make_cpu_world(scene, settings);
  std::vector<double> zs;
  Report last = world->report();
  for (int k = 0; k < blocks; ++k) {
    step_until(*world, k + 1 - settings.dt / 2);
    const Report now = world->report();
    const double kt = (last.kinetic_energy + now.kinetic_energy) / (3 * (count - 1));
    zs.push_back(1 + (now.tally.virial - last.tally.virial) / (3 * count * kt * (now.time - last.time)));
    last = now;
  }
  return mean_of(zs);
}

/// Z_N of 256 spheres at ρ = 0.5: Z = 3.26941 by Kolafa, Labík, Malijevský (2004), doi 10.1039/b402792b, and
/// N·(Z_N − Z) = −1.021, which follows from the compressibility.
constexpr double kReference = 3.26941 - 1.021 / 256;

}  // namespace

TEST_CASE("a fixed step lowers the pressure of a gas as if its spheres were smaller by √π/2·v·dt", "[slow]") {
  // A hit is seen when the spheres overlap already, dt/2 late in the mean, at a mean speed of approach of √π·√kT. So spheres
  // seem smaller by <u>·dt/2 = 0.886 dt, and dZ/dt = −3η·Z'(η)·√π/2 = −11.56 for a small step. At these steps the same formula
  // gives Z(ρ·(1 − 0.886 dt)³) − Z(ρ): −0.1123 and −0.2181.
  // Undoing overlap by position is no help: the hit is late all the same.
  struct Row {
    const char* correction;
    double dt, bias;
  };
  const Row row = GENERATE(Row{"none", 0.01, -0.1123}, Row{"none", 0.02, -0.2181}, Row{"split", 0.02, -0.2181});
  const Mean z = measured_z(melted_gas(4, 0.5, 1), impulses(row.dt, row.correction), 100);
  INFO(row.correction << ", dt = " << row.dt << ": Z − Z_exact = " << z.value - kReference << " ± " << z.error
                      << " for " << row.bias);
  CHECK(std::fabs(z.value - kReference - row.bias) < 3 * z.error);
  CHECK(z.error < 0.2 * std::fabs(row.bias));
}

TEST_CASE("exact motion and swept contacts have no such bias") {
  const Scene scene = melted_gas(4, 0.5, 1);
  const Mean exact = measured_z(scene, event_driven_gas(1.0), 100),
             swept = measured_z(scene, impulses(0.02, "none", true), 60);
  INFO("exact " << exact.value << " ± " << exact.error << ", swept " << swept.value << " ± " << swept.error << " for "
                << kReference);
  CHECK(std::fabs(exact.value - kReference) < 3 * exact.error);
  CHECK(std::fabs(swept.value - kReference) < 3 * swept.error);
  CHECK(swept.error < 0.05);
}

TEST_CASE(
    "in a dense gas without losses Gauss-Seidel with eight iterations keeps the energy, and Jacobi with four does "
    "not") {
  // Measured after 30 units of time, 230 collisions per sphere: Jacobi leaves 0.37 of the energy, Gauss-Seidel 0.99 with four
  // iterations and 1.001 with eight. Spheres with several contacts at once have not converged, and their restitution is less
  // than 1.
  const Scene scene = melted_gas(4, 0.5, 1);
  const auto part_left = [&](const std::string& solver, int iterations) {
    Settings settings = impulses(0.02, "none");
    settings.solver = named<Solver>(solver);
    settings.iterations = iterations;
    const auto world = make_cpu_world(scene, settings);
    const double before = world->report().kinetic_energy;
    step_until(*world, 30);
    return world->report().kinetic_energy / before;
  };
  CHECK(part_left("gauss-seidel", 8) == Approx(1).margin(0.005));
  CHECK(part_left("gauss-seidel", 4) == Approx(1).margin(0.05));
  CHECK(part_left("jacobi", 4) < 0.8);
}

TEST_CASE("impulses share the energy of a mixture with total momentum zero as 1 − m/M") {
  // M is the mass of all: the heavy sphere has half of it, and so 1/2 of a degree's share, each light one 61/62: of N − 1
  // shares in all. With a share for each sphere it would have 1/N, twice as much.
  Scene scene = make_lattice_gas(2, 0.3, 2);
  const double count = double(scene.bodies.size());
  Vec3d momentum(0.0);
  for (size_t i = 0; i < scene.bodies.position.size(); ++i) {
    scene.bodies.mass[i] = i == 0 ? 31.0 : 1.0;
    momentum += scene.bodies.mass[i] * scene.bodies.velocity[i];
  }
  for (Vec3d& v : scene.bodies.velocity) v -= momentum / 62.0;
  const auto world = make_cpu_world(scene, impulses(0.02, "split"));
  step_until(*world, 10);
  std::vector<double> blocks;  // the heavy sphere's part of the energy
  for (int k = 0; k < 40; ++k) {
    double heavy = 0;
    for (int sample = 0; sample < 25; ++sample) {
      step_until(*world, 11.0 + 25 * k + sample);
      const Vec3d v = world->bodies().velocity[0];
      heavy += 0.5 * 31 * dot(v, v) / world->report().kinetic_energy / 25;
    }
    blocks.push_back(heavy);
  }
  const double expected = 0.5 / (count - 1);
  const Mean measured = mean_of(blocks);
  INFO(measured.value << " ± " << measured.error << " for " << expected << "; energy "
                      << world->report().kinetic_energy);
  CHECK(std::fabs(measured.value - expected) < 3 * measured.error);
  CHECK(measured.error < 0.15 * expected);
}
