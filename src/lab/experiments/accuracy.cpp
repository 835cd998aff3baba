// SPDX-License-Identifier: MIT
// The table of tasks, and the tasks of spheres at rest one on top of the other. Rigid ones do not overlap.
#include "lab/experiments/accuracy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/experiments/timed_run.h"
#include "lab/measure/made_scenes.h"

namespace ballpit {

namespace {

/// The largest overlap at rest; a method fails if the floor does not carry the weight. Steps are no finer than 0.13 ms:
/// below that, single precision loses gravity's part in a step, and impulses sink into the allowed overlap for longer
/// than this waits.
Trial run_pile(const std::vector<double>& masses, const ContactMethod& method, double dt) {
  constexpr double kRadius = 0.125, kRest = 1.5, kWeighing = 0.25, kTolerance = 0.1;
  constexpr int64_t kMaxEvents = 20'000;  // more are an endless series of collisions
  Scene scene = make_stack(masses, kRadius);
  const double lightest = *std::min_element(masses.begin(), masses.end());
  scene.physics.stiffness = stiffness_for(dt, kStepsOfContact, lightest / 2, 0);
  Settings settings = with_step(method, dt);
  settings.keeps_tally = true;
  TimedRun run(scene, settings);
  for (const double until : {0.01, kRest}) {
    if (!run.reach(until)) return {kFailed, run.seconds()};
    if (run.world().report().events > kMaxEvents) return {kFailed, run.seconds()};
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
  const auto run = [masses](const ContactMethod& method, double dt, uint64_t, bool) {
    return run_pile(masses, method, dt);
  };
  return {name, title, "largest overlap / radius", "rigid spheres, which carry the weight", 1.0 / 60, quick_halvings,
          7,    run};
}

std::vector<double> equal(size_t count) { return std::vector<double>(count, 1.0); }

}  // namespace

const std::vector<Task>& tasks() {
  static const std::vector<Task> table = [] {
    std::vector<Task> all = contact_tasks();
    all.push_back(pile(equal(5), "stack-5", "Five spheres at rest, one upon the other", 5));
    all.push_back(pile(equal(10), "stack-10", "Ten spheres at rest, one upon the other", 6));
    all.push_back(pile(equal(20), "stack-20", "Twenty spheres at rest, one upon the other", 5));
    all.push_back(pile({1, 100}, "mass-ratio", "A sphere a hundred times as heavy upon a light one", 6));
    for (Task& task : gas_tasks()) all.push_back(std::move(task));
    return all;
  }();
  return table;
}

}  // namespace ballpit
