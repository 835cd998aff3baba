// SPDX-License-Identifier: MIT
// Tasks of spheres that stand on each other: rigid ones do not overlap.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/experiments/accuracy_parts.h"
#include "lab/experiments/timed_run.h"
#include "lab/measure/made_scenes.h"

namespace ballpit {

namespace {

/// The largest overlap once they rest. Who does not carry their weight is off by infinity. Steps are no finer than 0.13 ms: beyond that
/// gravity's part in a step is lost in single precision, and impulses sink into what overlap they allow for longer than this waits.
Trial run_pile(const std::vector<double>& masses, const ContactMethod& method, double dt) {
  constexpr double kRadius = 0.125, kRest = 1.5, kWeighing = 0.25, kTolerance = 0.1;
  constexpr int64_t kMostEvents = 20'000;  // in a run: more are collisions without end
  Scene scene = make_stack(masses, kRadius);
  const double lightest = *std::min_element(masses.begin(), masses.end());
  scene.physics.stiffness = stiffness_for(dt, kStepsOfContact, lightest / 2, 0);
  Settings settings = with_step(method, dt);
  settings.keeps_tally = true;
  TimedRun run(scene, settings);
  for (const double until : {0.01, kRest}) {
    if (!run.reach(until)) return {kFailed, run.seconds()};
    if (run.world().report().events > kMostEvents) return {kFailed, run.seconds()};
  }
  const double before = run.world().report().tally.floor_impulse;
  if (!run.reach(kRest + kWeighing)) return {kFailed, run.seconds()};
  const Report report = run.world().report();
  const double weight = (report.tally.floor_impulse - before) / kWeighing,
               expected = std::accumulate(masses.begin(), masses.end(), 0.0) * -scene.physics.gravity.y;
  const bool is_carried = std::fabs(weight / expected - 1) < kTolerance;
  return {is_carried ? report.max_overlap : kFailed, run.seconds()};
}

Task pile(const std::vector<double>& masses, const std::string& name, const std::string& title, int quick_halvings) {
  return {name,
          title,
          "largest overlap / radius",
          "rigid spheres, which carry the weight",
          1.0 / 60,
          quick_halvings,
          7,
          false,
          is_any,
          [masses](const ContactMethod& method, double dt, uint64_t, bool) { return run_pile(masses, method, dt); }};
}

std::vector<double> equal(size_t count) { return std::vector<double>(count, 1.0); }

}  // namespace

std::vector<Task> rest_tasks() {
  return {pile(equal(5), "stack-5", "Five spheres at rest, one upon the other", 5),
          pile(equal(10), "stack-10", "Ten spheres at rest, one upon the other", 6),
          pile(equal(20), "stack-20", "Twenty spheres at rest, one upon the other", 5),
          pile({1, 100}, "mass-ratio", "A sphere a hundred times as heavy upon a light one", 6)};
}

}  // namespace ballpit
