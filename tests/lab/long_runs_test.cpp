// SPDX-License-Identifier: MIT
// Which methods keep energy and momentum over long runs.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "lab/experiments/contact_methods.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"

using namespace ballpit;

namespace {

LargestDrift drift_in_gas(const std::string& name) {
  constexpr double kStep = 0.004;
  const auto& methods = contact_methods();
  const auto method =
      std::find_if(methods.begin(), methods.end(), [&](const ContactMethod& m) { return m.name == name; });
  REQUIRE(method != methods.end());
  Scene gas = equilibrium_gas(2, 0.3, 1);
  gas.physics.stiffness = stiffness_for(kStep, 30, 0.5, 1);
  Settings settings = method->settings;
  settings.dt = kStep;
  return drift_of(gas, settings, {5, 40}).back();
}

}  // namespace

TEST_CASE(
    "explicit Euler's energy grows by 1 + ω²dt² a step, Runge-Kutta's falls by (ωdt)⁶/72, the others' stays bounded") {
  constexpr double kOmegaStep = 0.1;
  constexpr int kCount = 12;
  for (const char* const name : {"explicit-euler", "symplectic-euler", "velocity-verlet", "rk4"}) {
    const std::vector<double> drifts = oscillator_drift(name, kOmegaStep, kCount);
    for (int k = 0; k < kCount; ++k) {
      const double steps = std::pow(2, k), expected = oscillator_theory(name, kOmegaStep, steps);
      if (expected > kOscillatorLeaves) break;
      INFO(name << ", " << steps << " steps: " << drifts[static_cast<size_t>(k)] << " for " << expected);
      const bool is_bounded = name == std::string("symplectic-euler") || name == std::string("velocity-verlet");
      if (is_bounded) {
        CHECK(drifts[static_cast<size_t>(k)] <= 1.001 * expected);
        if (steps > 2 * M_PI / kOmegaStep) CHECK(drifts[static_cast<size_t>(k)] >= 0.98 * expected);
      } else {
        CHECK(drifts[static_cast<size_t>(k)] == Approx(expected).epsilon(0.001));
      }
    }
  }
}

TEST_CASE("explicit Euler fails in a gas where velocity Verlet holds") {
  CHECK(std::isinf(drift_in_gas("penalty, explicit-euler").energy));
  CHECK(drift_in_gas("penalty, velocity-verlet").energy < 0.01);
  CHECK(drift_in_gas("penalty, rk4").energy < 0.01);
}

TEST_CASE("every response but the kinematic one keeps momentum to rounding") {
  for (const ContactMethod& method : contact_methods()) {
    const LargestDrift drift = drift_in_gas(method.name);
    INFO(method.name << ": momentum " << drift.momentum << ", energy " << drift.energy);
    if (method.settings.response == Response::kinematic) {
      CHECK(drift.momentum > 0.01);
    } else if (std::isfinite(drift.momentum)) {
      CHECK(drift.momentum < (method.settings.precision == Precision::float32 ? 1e-5 : 1e-13));
    } else {
      CHECK(method.settings.integrator == Integrator::explicit_euler);
    }
  }
}

TEST_CASE("exact motion keeps energy to rounding") { CHECK(drift_in_gas("event-driven").energy < 1e-12); }
