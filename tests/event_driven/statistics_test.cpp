// SPDX-License-Identifier: MIT
// Event-driven motion against kinetic theory: averages of many spheres, which do not depend on their chaotic paths.
//
// The standard errors of means follow from averages over blocks of many collisions, which are practically independent.
// A test allows three standard errors; the seeds fix the numbers below.
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/hard_sphere_gas.h"

using namespace ballpit;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Z of hard spheres at the density rho, to 4e-5 for rho in 0.2 to 1.03: a fit to the data of Kolafa, Labík, Malijevský
/// (2004), doi 10.1039/b402792b, in x = η/(1 − η).
double reference_z(double rho) {
  const double eta = kPi * rho / 6, x = eta / (1 - eta);
  const double power[] = {1, 2, 3, 4, 5, 6, 7, 8, 10, 14, 22};
  const double factor[] = {4,          6,           2.3647684,   -0.8698551, 1.1062803, -1.1014221,
                           0.66605866, -0.03633431, -0.20965164, 0.10555569, -0.0087238};
  double z = 1;
  for (int k = 0; k < 11; ++k) z += factor[k] * std::pow(x, power[k]);
  return z;
}

/// Collisions per sphere and unit time of N spheres with total momentum zero: Γ = (6/√π)·(Z_N − 1)·√kT·f, where f
/// makes the mean relative speed that of g = 3(N − 1) degrees of freedom on a sphere of constant energy.
double reference_rate(double z, double count) {
  const double g = 3 * (count - 1);
  const double f = std::exp(std::lgamma(g / 2) - std::lgamma((g + 1) / 2)) * std::sqrt(g / 2);
  return 6 / std::sqrt(kPi) * (z - 1) * f;
}

}  // namespace

TEST_CASE("event-driven: pressure and collision rate of hard spheres are those of the literature", "[slow]") {
  // The virial theorem: 3PV = Σ m·v² + W/t, where W is the sum of Δp·d over the time t. In N spheres with total
  // momentum zero, Σ m·v² = 3(N − 1)·kT; the centre of mass at rest is counted as one more ideal particle, and so Z_N =
  // PV/(N·kT) = 1 + W/(3·N·kT·t). It differs from Z by size_effect/N, which follows from the fluid's compressibility.
  struct Point {
    double rho, size_effect;
  };
  const Point point = GENERATE(Point{0.1, -0.205}, Point{0.5, -1.021}, Point{0.7, -1.511});
  const Scene scene = melted_gas(5, point.rho, 1);
  const double count = double(scene.bodies.size());
  const double z = reference_z(point.rho) + point.size_effect / count, rate = reference_rate(z, count);
  const double block = 40 / rate;  // 40 collisions per sphere
  const auto world = make_cpu_world(scene, event_driven_gas(block));
  std::vector<double> zs, rates;
  Tally last;
  for (int k = 0; k < 100; ++k) {
    world->step();
    const Tally now = world->report().tally;
    zs.push_back(1 + (now.virial - last.virial) / (3 * count * block));
    rates.push_back(2 * double(now.collisions - last.collisions) / (count * block));
    last = now;
  }
  const Mean measured_z = mean_of(zs), measured_rate = mean_of(rates);
  INFO("rho = " << point.rho << ": Z = " << measured_z.value << " ± " << measured_z.error << " for " << z
                << ", rate = " << measured_rate.value << " ± " << measured_rate.error << " for " << rate);
  CHECK(std::fabs(measured_z.value - z) < 3 * measured_z.error);
  CHECK(std::fabs(measured_rate.value - rate) < 3 * measured_rate.error);
  CHECK(measured_z.error < 0.001 * z);
}

TEST_CASE("event-driven: equal speeds become those of Maxwell, with the fourth moment of a finite gas") {
  // ⟨v⁴⟩/⟨v²⟩² = (5/3)·g/(g + 2) for g = 3(N − 1) degrees of freedom that share a constant energy: 1.6316 for N = 32.
  Scene scene = make_lattice_gas(2, 0.5, 4);
  const double g = 3 * (double(scene.bodies.size()) - 1), expected = 5.0 / 3 * g / (g + 2);
  const auto world = make_cpu_world(scene, event_driven_gas(2.0));  // 15 collisions per sphere
  std::vector<double> blocks;
  for (int k = 0; k < 40; ++k) {
    double fourth = 0, second = 0;
    for (int sample = 0; sample < 40; ++sample) {
      world->step();
      for (const Vec3d& v : world->bodies().velocity) {
        second += dot(v, v);
        fourth += dot(v, v) * dot(v, v);
      }
    }
    const double samples = 40.0 * double(scene.bodies.size());
    blocks.push_back(fourth / samples / (second / samples * second / samples));
  }
  const Mean measured = mean_of(blocks);
  INFO(measured.value << " ± " << measured.error << " for " << expected);
  CHECK(std::fabs(measured.value - expected) < 3 * measured.error);
  CHECK(5.0 / 3 - measured.value > 3 * measured.error);
}

TEST_CASE("event-driven: a gas that loses energy cools by Haff's law") {
  // T = T0·(1 + t/τ)^−2 with τ = 6/((1 − e²)·Γ0), while it is homogeneous. Haff, "Grain flow as a fluid-mechanical
  // phenomenon" (1983), doi 10.1017/S0022112083003419.
  const double rho = 0.1, e = 0.9;
  std::vector<double> early, late;
  double tau = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    Scene scene = melted_gas(3, rho, seed);
    const double count = double(scene.bodies.size());
    tau = 6 / ((1 - e * e) * reference_rate(reference_z(rho), count));
    scene.physics.restitution = e;
    const auto world = make_cpu_world(scene, event_driven_gas(tau));
    const double energy = world->report().kinetic_energy;
    world->step();
    early.push_back(world->report().kinetic_energy / energy);
    world->step();
    late.push_back(world->report().kinetic_energy / energy);
  }
  // Speeds are no longer quite Maxwell's: the rate differs by less than a percent at e = 0.9, the energy by less than
  // two.
  INFO("τ = " << tau << ": " << mean_of(early).value << " ± " << mean_of(early).error << " after τ, "
              << mean_of(late).value << " ± " << mean_of(late).error << " after 2τ");
  CHECK(mean_of(early).value == Approx(1.0 / 4).epsilon(0.02));
  CHECK(mean_of(late).value == Approx(1.0 / 9).epsilon(0.02));
}

TEST_CASE("event-driven: the mean force on the floor is N·m·g") {
  // Momentum balance without a ceiling: what the floor gave is m·g·N·t and what the spheres' momentum has gained,
  // exactly. The second part is bounded, so the mean force tends to N·m·g.
  Scene scene;
  scene.domain = {Vec3d(0.0), {5, 8, 5}, Boundary::open_top, 3};
  scene.physics.gravity = {0, -2, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  Random random(8);
  for (int k = 0; k < 64; ++k) {
    add_sphere(scene, Vec3d(0.7 + 1.2 * (k % 4), 0.7 + 1.2 * (k / 16), 0.7 + 1.2 * (k / 4 % 4)),
               random.uniform(Vec3d(-3.0), Vec3d(3.0)), 0.5, 1.5);
  }
  const double weight = 64 * 1.5 * 2, time = 400;
  const auto world = make_cpu_world(scene, event_driven_gas(time));
  const Report start = world->report();
  world->step();
  const Report end = world->report();
  const double gained = end.momentum.y - start.momentum.y;
  CHECK(end.tally.floor_impulse == Approx(weight * time + gained).epsilon(1e-11));
  CHECK(end.tally.floor_impulse / time == Approx(weight).epsilon(0.005));
  CHECK(end.kinetic_energy + end.potential_energy ==
        Approx(start.kinetic_energy + start.potential_energy).epsilon(1e-11));
}

TEST_CASE("event-driven: in a mixture with total momentum zero, energies are as 1 − m/M") {
  // M is the mass of all: the heavy sphere has half of it. Of 3(N − 1) degrees of freedom, each species gets its share.
  Scene scene = make_lattice_gas(2, 0.3, 2);
  const size_t count = scene.bodies.position.size();
  Vec3d momentum(0.0);
  for (size_t i = 0; i < count; ++i) {
    scene.bodies.mass[i] = i == 0 ? 31.0 : 1.0;
    momentum += scene.bodies.mass[i] * scene.bodies.velocity[i];
  }
  for (Vec3d& v : scene.bodies.velocity) v -= momentum / 62.0;
  const auto world = make_cpu_world(scene, event_driven_gas(1.0));
  world->step();
  std::vector<double> blocks;  // the heavy sphere's part of the energy
  for (int k = 0; k < 50; ++k) {
    double heavy = 0;
    for (int sample = 0; sample < 100; ++sample) {
      world->step();
      const Vec3d v = world->bodies().velocity[0];
      heavy += 0.5 * 31 * dot(v, v) / world->report().kinetic_energy / 100;
    }
    blocks.push_back(heavy);
  }
  // Σ (1 − m/M) = N − 1, of which the heavy sphere has 1/2 and each light one 61/62.
  const double expected = 0.5 / double(count - 1);
  const Mean measured = mean_of(blocks);
  INFO(measured.value << " ± " << measured.error << " for " << expected);
  CHECK(std::fabs(measured.value - expected) < 3 * measured.error);
  CHECK(measured.error < 0.05 * expected);
}
