// SPDX-License-Identifier: MIT
#include "choose/pilot.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/error.h"
#include "core/interrupt.h"
#include "scene/sphere_index.h"

namespace ballpit {

namespace {

using Clock = std::chrono::steady_clock;

/// Looks at the overlap near the end, since one moment may be lucky, and throughout if the needs say so.
bool is_to_be_seen(const Needs& needs, int64_t step, int64_t steps) {
  if (needs.max_overlap_ever || !needs.observables.empty()) return true;
  return step == steps - steps / 20 || step == steps - steps / 40;
}

/// Steps between two looks that only the chart wants. Few spheres seldom touch, so they are looked at more often.
int64_t steps_between_looks(int64_t steps, int64_t count) {
  return std::max<int64_t>(1, steps / std::clamp<int64_t>(4000 / std::max<int64_t>(count, 1), 16, 128));
}

void see(Seen& seen, const Report& report, double start_energy) {
  seen.overlap = std::max(seen.overlap, report.max_overlap);
  if (start_energy != 0) seen.drift = std::max(seen.drift, std::fabs(energy_of(report) / start_energy - 1));
}

/// Errors at the end of a run, from those at a share of it.
void judge(PilotResult& result, std::vector<double> errors, double share, const Needs& needs) {
  const std::vector<Tolerance> tolerances = tolerances_of(needs);
  result.is_unseen.assign(tolerances.size(), false);
  for (size_t k = 0; k < tolerances.size(); ++k) {
    const bool is_overlap = tolerances[k].name == "max_overlap";
    if (is_overlap) result.end_overlap = errors[k];
    if (is_overlap) errors[k] = std::max(errors[k], result.largest_overlap);
    if (is_overlap) result.largest_overlap = errors[k];
    if (tolerances[k].grows && share > 0) errors[k] /= share;
    // What comes to rest later is not seen by a short run.
    result.is_unseen[k] = !result.is_complete && tolerances[k].name == "max_speed" && errors[k] > tolerances[k].allowed;
  }
  result.errors = std::move(errors);
}

}  // namespace

Scene part_of(const Scene& scene, int64_t most) {
  const int64_t count = scene.bodies.size();
  if (count <= most) return scene;
  Scene part = scene;
  const Vec3d& g = scene.physics.gravity;
  std::vector<int> cut;
  for (int axis = 0; axis < scene.domain.dimensions; ++axis) {
    const bool is_deep = length(g) > 0 && std::fabs(g[axis]) >= 0.5 * length(g);
    if (!is_deep) cut.push_back(axis);
  }
  const double factor = std::pow(double(most) / double(count), 1.0 / double(std::max<size_t>(1, cut.size())));
  const double least = 6 * *std::ranges::max_element(scene.bodies.radius);
  for (const int axis : cut) {
    const double edge = scene.domain.max[axis] - scene.domain.min[axis];
    part.domain.max[axis] = scene.domain.min[axis] + std::min(edge, std::max(least, factor * edge));
  }
  part.bodies = {};
  const auto is_inside = [&](const Vec3d& p) {
    return std::ranges::all_of(cut, [&](int axis) { return p[axis] <= part.domain.max[axis]; });
  };
  SphereIndex index(part.domain);  // in a periodic part spheres may meet across its new borders
  const bool is_periodic = scene.domain.boundary == Boundary::periodic;
  Vec3d end = part.domain.max;
  for (size_t i = 0; i < scene.bodies.radius.size() && part.bodies.size() < most; ++i) {
    const Vec3d& p = scene.bodies.position[i];
    const double radius = scene.bodies.radius[i];
    if (!is_inside(p) || (is_periodic && !index.is_free(p, radius, 0))) continue;
    if (is_periodic) index.insert(static_cast<int32_t>(part.bodies.size()), p, radius);
    for (const int axis : cut) end[axis] = std::max(end[axis], p[axis] + radius);
    part.bodies.position.push_back(p);
    part.bodies.velocity.push_back(scene.bodies.velocity[i]);
    part.bodies.radius.push_back(radius);
    part.bodies.mass.push_back(scene.bodies.mass[i]);
  }
  // Walls stand where the spheres end, so that these are as dense as in the whole.
  if (!is_periodic) part.domain.max = end;
  return part;
}

int64_t steps_to(double time, const Settings& settings) {
  return static_cast<int64_t>(std::llround(std::min(time / settings.dt, 1e15)));
}

std::unique_ptr<World> make_pilot_world(const Scene& scene, const Needs& needs, Settings settings) {
  settings.keeps_tally = need_tally(needs);
  const bool uses_cuda = settings.backend == BackendName::cuda && settings.response != Response::event_driven;
  return (uses_cuda ? cuda_backend() : cpu_backend()).make_world(scene, settings);
}

PilotResult run_pilot(const PilotPlan& plan, const Settings& settings) {
  constexpr double kSure = 0.1;  // of the run: then its cost is known well enough to give it up
  PilotResult result;
  const int64_t all_steps = steps_to(plan.needs.duration, settings), steps = steps_to(plan.until, settings);
  Settings own = settings;
  own.patience = plan.seconds;
  std::unique_ptr<World> world;
  try {
    world = make_pilot_world(plan.scene, plan.needs, own);
  } catch (const RunError& error) {  // a start that the response cannot have
    result.stopped = error.what();
    return result;
  }
  NeedsMeter meter(plan.scene, plan.needs, *world);
  const double start_energy = energy_of(world->report());
  const int64_t stride = steps_between_looks(steps, plan.scene.bodies.size());
  double spent = 0;
  int64_t done = 0;
  const auto share = [&] { return all_steps > 0 ? double(done) / double(all_steps) : 1.0; };
  try {
    while (done < steps && spent <= plan.seconds && !result.is_given_up) {
      stop_if_interrupted();
      if (plan.stop.stop_requested()) throw Interrupted();
      const auto start = Clock::now();
      world->step();
      spent += std::chrono::duration<double>(Clock::now() - start).count();
      ++done;
      if (done == std::max<int64_t>(1, steps / 2)) result.middle = world->bodies();
      if (is_to_be_seen(plan.needs, done, steps)) {
        meter.look(*world);
        result.largest_overlap = std::max(result.largest_overlap, world->report().max_overlap);
      }
      if (done % stride == 0 || done == steps) see(result.seen, world->report(), start_energy);
      result.is_given_up = share() > kSure && spent / share() > plan.dearest;
    }
  } catch (const RunError& error) {
    result.stopped = error.what();
  } catch (const UserError& error) {  // too much memory
    result.stopped = error.what();
  }
  result.reached = world->time();
  result.cost = share() > 0 ? spent / share() : spent;
  if (!result.stopped.empty()) return result;
  result.is_at_truth = done == steps;
  result.is_complete = done == all_steps;
  if (share() > 0) result.seen.drift /= share();
  if (result.middle.size() == 0) result.middle = world->bodies();
  result.truth = meter.truth(*world);
  judge(result, meter.errors(*world, result.is_at_truth ? plan.truth : Truth{}), share(), plan.needs);
  return result;
}

double worst_ratio(const PilotResult& result, const std::vector<Tolerance>& tolerances) {
  if (!result.stopped.empty()) return INFINITY;
  double worst = 0;
  for (size_t k = 0; k < tolerances.size(); ++k) {
    const double error = result.errors[k], allowed = tolerances[k].allowed;
    if (error == 0 || result.is_unseen[k]) continue;
    const double ratio = allowed > 0 && std::isfinite(error) ? error / allowed : INFINITY;
    worst = std::max(worst, ratio);
  }
  return worst;
}

bool holds(const PilotResult& result, const std::vector<Tolerance>& tolerances, double margin) {
  return !result.is_given_up && worst_ratio(result, tolerances) <= margin;
}

}  // namespace ballpit
