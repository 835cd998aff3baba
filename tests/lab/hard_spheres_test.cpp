// SPDX-License-Identifier: MIT
// Pressure and cooling of gases, measured as in the experiments, against theory.
#include <cmath>

#include <catch2/catch.hpp>

#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"
#include "measure/statistics.h"
#include "measure/theory.h"

using namespace ballpit;

TEST_CASE("the pressure of exact motion is that of the literature within its error") {
  const double rho = GENERATE(0.2, 0.5, 0.8);
  const GasRun run{4, rho, 1, 60, 20};
  const Mean z = mean_of(block_z(run, exact_motion(1)));
  INFO("Z = " << z.value << " ± " << z.error << " for " << finite_z(rho, count_of(run)));
  CHECK(std::fabs(z.value - finite_z(rho, count_of(run))) < 3 * z.error);
  CHECK(z.error < 0.004 * z.value);
}

TEST_CASE("a fixed step lowers the pressure as late contacts do, and swept contacts do not") {
  const GasRun run{4, 0.5, 1, 60, 15};
  const double exact = finite_z(0.5, count_of(run)), dt = 0.04;
  const Mean discrete = mean_of(block_z(run, elastic_impulses(dt, false))),
             swept = mean_of(block_z(run, elastic_impulses(dt, true)));
  INFO("discrete " << discrete.value << " ± " << discrete.error << ", swept " << swept.value << " ± " << swept.error);
  CHECK(std::fabs(discrete.value - late_contact_z(0.5, count_of(run), dt)) < 3 * discrete.error);
  CHECK(std::fabs(swept.value - exact) < 3 * swept.error);
  CHECK(exact - discrete.value > 20 * discrete.error);
}

TEST_CASE("a gas cools by Haff's law: τ is that of kinetic theory to two percent") {
  std::vector<double> taus;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const double part = cooling({4, 0.1, seed, 0, 0}, 0.9, {1.0}).front();
    taus.push_back(1 / (1 / std::sqrt(part) - 1));
  }
  const Mean tau = mean_of(taus);
  INFO("τ of theory's: " << tau.value << " ± " << tau.error);
  CHECK(tau.value == Approx(1).epsilon(0.02));
  CHECK(tau.error < 0.01);
}

TEST_CASE("a gas without losses does not cool") {
  CHECK(cooling({2, 0.1, 1, 0, 0}, 0.9, {0.5, 3.0}).back() < 0.1);
  const Scene gas = equilibrium_gas(2, 0.1, 1);
  const auto world = make_world_on_cpu(gas, exact_motion(10));
  const double before = world->report().kinetic_energy;
  world->step();
  CHECK(world->report().kinetic_energy == Approx(before).epsilon(1e-12));
}
