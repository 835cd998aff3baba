// SPDX-License-Identifier: MIT
// Worlds with timelines for the tests, and what is to be the same after going back.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "show/timeline.h"
#include "tests/support/kinds.h"

namespace ballpit {

/// What is to be the same again.
struct Checkpoint {
  uint64_t state_hash;
  int64_t steps, collisions, wall_hits, events;
  double virial, floor_impulse, good_time;
  std::vector<Vec3d> good_position;

  /// Sums over contacts may be bracketed otherwise: the candidate list, of which the penalty response sums up all pairs, may
  /// be another. All else is the same to the bit.
  bool operator==(const Checkpoint& other) const {
    return state_hash == other.state_hash && steps == other.steps && collisions == other.collisions &&
           wall_hits == other.wall_hits && events == other.events && virial == Approx(other.virial).epsilon(1e-12) &&
           floor_impulse == other.floor_impulse && good_time == other.good_time && good_position == other.good_position;
  }
};

inline std::ostream& operator<<(std::ostream& out, const Checkpoint& checkpoint) {
  return out << "hash " << checkpoint.state_hash << ", steps " << checkpoint.steps << ", collisions "
             << checkpoint.collisions << ", hits of walls " << checkpoint.wall_hits << ", events " << checkpoint.events
             << ", virial " << checkpoint.virial << ", last good at " << checkpoint.good_time;
}

inline Checkpoint checkpoint_of(World& world) {
  const Report report = world.report();
  return {report.state_hash,          report.steps,           report.tally.collisions,
          report.tally.wall_hits,     report.events,          report.tally.virial,
          report.tally.floor_impulse, world.last_good_time(), world.last_good().position};
}

/// A world with its timeline, and the moments that were seen when it first was there.
struct Run {
  std::unique_ptr<World> world;
  Timeline timeline;
  std::map<int64_t, Checkpoint> seen;

  Run(const Scene& scene, const Settings& settings, int64_t budget = Timeline::kBudget)
      : world(make_cpu_world(scene, settings)), timeline(*world, settings.dt, budget) {}

  /// Steps so far, and looks at those that are to be compared; at all if none is named.
  void first_time(int64_t steps, const std::set<int64_t>& looked_at = {}) {
    for (int64_t k = 0;; ++k) {
      if (looked_at.empty() || looked_at.contains(k)) seen.emplace(k, checkpoint_of(*world));
      if (k == steps) return;
      timeline.step();
    }
  }

  void check_now() {
    const auto then = seen.find(timeline.step_now());
    if (then != seen.end()) CHECK(checkpoint_of(*world) == then->second);
  }

  /// Goes there, and on for some steps.
  void check_from(int64_t step, int64_t more) {
    const int64_t furthest = timeline.furthest();
    CHECK(timeline.go_to(step));
    INFO("at step " << step);
    REQUIRE(timeline.step_now() == step);
    check_now();
    for (int64_t k = 0; k < more && timeline.step_now() < furthest; ++k) {
      INFO("and " << k + 1 << " steps");
      timeline.step();
      check_now();
    }
    CHECK(timeline.furthest() == furthest);
  }
};

}  // namespace ballpit
