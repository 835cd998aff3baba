// SPDX-License-Identifier: MIT
// Restitution and damping of a spring-dashpot contact.
#include <cmath>

#include <catch2/catch.hpp>

#include "response/pair_force.h"

using namespace ballpit;

TEST_CASE("a contact damped by a tenth has the restitution of the closed form, by either end") {
  // exp(−πζ/√(1−ζ²)), and exp(−2ζ·acos ζ/√(1−ζ²)) (Schwager and Pöschel 2007); digits verified by independent
  // experiment.
  CHECK(restitution_to_overlap_end(0.1) == Approx(0.729248).margin(5e-7));
  CHECK(restitution_to_force_end(0.1) == Approx(0.744079).margin(5e-7));
  CHECK(restitution_to_overlap_end(0.6) == Approx(0.0948).margin(5e-5));
  CHECK(restitution_to_force_end(0.6) == Approx(0.2488).margin(5e-5));
}

TEST_CASE("damping and restitution are each other's inverse") {
  for (const double e : {0.02, 0.1, 0.5, 0.8, 0.99}) {
    CHECK(restitution_to_overlap_end(damping_of(e, false)) == Approx(e).epsilon(1e-9));
    CHECK(restitution_to_force_end(damping_of(e, true)) == Approx(e).epsilon(1e-9));
  }
  CHECK(damping_of(1.0, false) == 0.0);
  CHECK(damping_of(1.0, true) == 0.0);
}

TEST_CASE("restitution 0 is damped as the least that springs can have") {
  CHECK(damping_of(0.0, false) == damping_of(kMinRestitution, false));
  CHECK(std::isfinite(damping_of(0.0, true)));
}

TEST_CASE("restitution to the end of force is smooth where damping becomes critical") {
  CHECK(restitution_to_force_end(1.0) == Approx(restitution_to_force_end(1 - 1e-9)).epsilon(1e-6));
  CHECK(restitution_to_force_end(1.0) == Approx(restitution_to_force_end(1 + 1e-9)).epsilon(1e-6));
}
