// SPDX-License-Identifier: MIT
// A change of units or of the order of spheres changes no choice beyond ties, and a smaller tolerance never makes it
// cheaper. Two choices tie if both hold and cost about the same in the same scene; costs below 10 ms are equal.
#include <algorithm>
#include <numeric>

#include <catch2/catch.hpp>

#include "lab/measure/held_out.h"
#include "lab/measure/regret.h"
#include "scene/read_scene.h"

using namespace ballpit;

namespace {

constexpr double kTie = 2;  // times are noisy where tests run beside each other
constexpr double kBudget = 1.5;

Scene scene_of(uint64_t seed, const Units& units = {}, double tolerance = 1) {
  return parse_scene(held_out_scene(seed, units, tolerance).text, "a.toml");
}

/// [s] of the choice in a full run of the scene: the least of three.
double cost_of(const Scene& scene, const Settings& settings, bool& holds) {
  double least = INFINITY;
  const Truth truth = full_truth(scene, scene.needs);
  for (int k = 0; k < 3; ++k) {
    const FullRun run = full_run(scene, scene.needs, truth, settings, 60);
    holds = run.holds;
    least = std::min(least, run.seconds);
  }
  return std::max(least, kEqualCosts);
}

Settings chosen(const Scene& scene) {
  const Choice choice = choose({scene, {}, kBudget});
  INFO(choice.reason);
  REQUIRE(choice.chosen);
  return choice.chosen->settings;
}

}  // namespace

TEST_CASE("units do not change a choice", "[slow]") {
  for (const uint64_t seed : {5, 9, 10, 13, 16, 21}) {
    const Units units{1e3, 1e-2, 1e-3};
    const Scene scene = scene_of(seed);
    Settings other = chosen(scene_of(seed, units));
    other.dt /= units.time;
    other.contact_duration /= units.time;
    bool holds = false, other_holds = false;
    const double cost = cost_of(scene, chosen(scene), holds), other_cost = cost_of(scene, other, other_holds);
    INFO("seed " << seed << ": " << cost << " s, in other units " << other_cost << " s");
    CHECK(holds);
    CHECK(other_holds);
    CHECK(cost < kTie * other_cost);
    CHECK(other_cost < kTie * cost);
  }
}

TEST_CASE("the order of spheres does not change a choice", "[slow]") {
  for (const uint64_t seed : {5, 13, 15, 21}) {
    const Scene scene = scene_of(seed);
    Scene other = scene;
    const auto n = other.bodies.radius.size();
    for (size_t i = 0; i < n; ++i) {  // 7 has no common divisor with most numbers
      const size_t from = n % 7 == 0 ? n - 1 - i : i * 7 % n;
      other.bodies.position[i] = scene.bodies.position[from];
      other.bodies.velocity[i] = scene.bodies.velocity[from];
      other.bodies.radius[i] = scene.bodies.radius[from];
      other.bodies.mass[i] = scene.bodies.mass[from];
    }
    bool holds = false, other_holds = false;
    const double cost = cost_of(scene, chosen(scene), holds), other_cost = cost_of(other, chosen(other), other_holds);
    INFO("seed " << seed << ": " << cost << " s, in another order " << other_cost << " s");
    CHECK(holds);
    CHECK(other_holds);
    CHECK(cost < kTie * other_cost);
    CHECK(other_cost < kTie * cost);
  }
}

TEST_CASE("half of the tolerance is not cheaper", "[slow]") {
  for (const uint64_t seed : {9, 12, 14, 15}) {
    bool holds = false;
    const Scene loose = scene_of(seed), tight = scene_of(seed, {}, 0.5);
    const double cost = cost_of(loose, chosen(loose), holds), tight_cost = cost_of(tight, chosen(tight), holds);
    INFO("seed " << seed << ": " << cost << " s, with half of the tolerance " << tight_cost << " s");
    CHECK(cost < 1.3 * tight_cost);
  }
}

TEST_CASE("held-out scenes follow from their seeds, and units change only their figures") {
  for (uint64_t seed = 1; seed <= 14; ++seed) {
    const HeldOutScene scene = held_out_scene(seed, {});
    CHECK(scene.text == held_out_scene(seed, {}).text);
    const Scene plain = scene_of(seed), other = scene_of(seed, {1e3, 1e2, 1e-3});
    REQUIRE(plain.bodies.size() == other.bodies.size());
    CHECK(other.needs.duration == Approx(1e2 * plain.needs.duration));
    CHECK(numbers_of(other).packing == Approx(numbers_of(plain).packing));
    CHECK(other.needs.max_overlap == plain.needs.max_overlap);
    CHECK(*scene_of(seed, {}, 0.5).needs.max_overlap == Approx(*plain.needs.max_overlap / 2));
  }
}
