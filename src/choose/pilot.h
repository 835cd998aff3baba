// SPDX-License-Identifier: MIT
// A pilot: a short run that measures what settings cost and whether they hold the tolerances of a scene. A scene of
// many spheres is piloted as a smaller one of its kind: a part of its domain, as deep as the whole, with the spheres in
// it.
#pragma once

#include <stop_token>

#include "choose/needs_meter.h"

namespace ballpit {

inline constexpr int64_t kMaxPilotSpheres = 2000;

/// At most about `most` spheres of the scene: those in a part of the domain, cut across gravity, or across all axes
/// without it. The scene itself if it has no more.
Scene part_of(const Scene& scene, int64_t most);

struct PilotPlan {
  const Scene& scene;  ///< to be run: the whole, or a part of it
  const Needs& needs;
  const Truth& truth;         ///< of the time `until`
  double until;               ///< [s] of simulated time at which the pilot ends; at most the needs' duration
  double seconds = 1;         ///< [s] of computing after which the pilot ends
  double dearest = INFINITY;  ///< [s] of computing for the needs' duration; a pilot that will cost more is given up
  std::stop_token stop{};     ///< ends the pilot, by Interrupted
};

/// The largest errors that looks during a run saw, needed or not: those of the chart of speed against accuracy.
struct Seen {
  double overlap = 0;  ///< of the smaller radius
  double drift = 0;    ///< change of energy, as a fraction of that at the start
};

struct PilotResult {
  double reached = 0;           ///< [s] of simulated time
  double cost = 0;              ///< [s] of computing for the needs' duration, with as many spheres as the pilot has
  std::vector<double> errors;   ///< of each tolerance, at the time reached; those that grow are scaled to the end
  std::vector<bool> is_unseen;  ///< which of them a run that ends early cannot show
  double largest_overlap = 0;   ///< of the looks at it
  double end_overlap = 0;       ///< at the time reached
  Seen seen{};                  ///< the drift scaled to the end
  std::string stopped;          ///< why the run was stopped by its guard; empty if it was not
  bool is_given_up = false;     ///< for its cost
  bool is_at_truth = false;     ///< it reached `until`
  bool is_complete = false;     ///< it reached the needs' duration
  Truth truth{};                ///< its own end
  Bodies middle{};              ///< the state at half of the time, or at its own end
};

/// Throws Interrupted if the program is interrupted, or the pilot asked to stop.
PilotResult run_pilot(const PilotPlan& plan, const Settings& settings);

/// Whether all errors are within `margin` of their tolerances.
bool holds(const PilotResult& result, const std::vector<Tolerance>& tolerances, double margin);

/// The largest error by its tolerance; infinite for a run that was stopped.
double worst_ratio(const PilotResult& result, const std::vector<Tolerance>& tolerances);

/// Steps from the start to the state nearest to `time` [s].
int64_t steps_to(double time, const Settings& settings);

/// The world of these settings on their backend, with a tally if the needs ask for one.
std::unique_ptr<World> make_pilot_world(const Scene& scene, const Needs& needs, Settings settings);

}  // namespace ballpit
