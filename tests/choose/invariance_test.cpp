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

/// Two choices in full runs, in turns, so that other load affects both.
struct Compared {
  struct One {
    bool holds = true;
    double cost = INFINITY;  ///< [s] the least of all turns
  };
  One first, second;

  Compared(const Scene& scene, const Settings& settings, const Scene& other_scene, const Settings& other_settings) {
    constexpr int kTurns = 4;
    const Truth truth = full_truth(scene, scene.needs), other_truth = full_truth(other_scene, other_scene.needs);
    for (int turn = 0; turn < kTurns; ++turn) {
      add(first, full_run(scene, scene.needs, truth, settings, 60));
      add(second, full_run(other_scene, other_scene.needs, other_truth, other_settings, 60));
    }
  }

  static void add(One& one, const FullRun& run) {
    one.holds = one.holds && run.holds;
    one.cost = std::max(kEqualCosts, std::min(one.cost, run.seconds));
  }

  void check_tie() const {
    INFO(first.cost << " s and " << second.cost << " s");
    CHECK(first.holds);
    CHECK(second.holds);
    CHECK(first.cost < kTie * second.cost);
    CHECK(second.cost < kTie * first.cost);
  }
};

Attempt chosen(const Scene& scene) {
  const Choice choice = choose({scene, {}, kBudget});
  INFO(choice.reason);
  REQUIRE(choice.chosen);
  return *choice.chosen;
}

/// Sanitizers make pilots so slow that they may be cut short; then two choices are compared only if both saw enough.
bool are_seen([[maybe_unused]] const Attempt& a, [[maybe_unused]] const Attempt& b) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return a.holds && b.holds;
#else
  return true;
#endif
}

}  // namespace

TEST_CASE("units do not change a choice", "[slow]") {
  for (const uint64_t seed : {5, 9, 10, 13, 16, 21}) {
    const Units units{1e3, 1e-2, 1e-3};
    const Scene scene = scene_of(seed);
    const Attempt first = chosen(scene);
    Attempt second = chosen(scene_of(seed, units));
    if (!are_seen(first, second)) continue;
    second.settings.dt /= units.time;
    second.settings.contact_duration /= units.time;
    INFO("seed " << seed);
    Compared(scene, first.settings, scene, second.settings).check_tie();
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
    INFO("seed " << seed);
    const Attempt first = chosen(scene), second = chosen(other);
    if (are_seen(first, second)) Compared(scene, first.settings, other, second.settings).check_tie();
  }
}

TEST_CASE("half of the tolerance is not cheaper", "[slow]") {
  for (const uint64_t seed : {9, 12, 14, 15}) {
    const Scene loose = scene_of(seed), tight = scene_of(seed, {}, 0.5);
    const Attempt first = chosen(loose), second = chosen(tight);
    if (!are_seen(first, second)) continue;
    const Compared costs(loose, first.settings, tight, second.settings);
    INFO("seed " << seed << ": " << costs.first.cost << " s, with half of the tolerance " << costs.second.cost << " s");
    CHECK(costs.first.holds);
    CHECK(costs.second.holds);
    CHECK(costs.first.cost < 1.5 * costs.second.cost);
  }
}

TEST_CASE("held-out scenes are scenes in all units that are drawn", "[slow]") {
  for (uint64_t seed = 1; seed <= 700; ++seed) {
    INFO(seed);
    CHECK_NOTHROW(scene_of(seed, drawn_units(seed)));
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
