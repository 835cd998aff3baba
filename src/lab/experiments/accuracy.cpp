// SPDX-License-Identifier: MIT
#include "lab/experiments/accuracy.h"

#include <algorithm>
#include <cmath>

#include "lab/experiments/timed_run.h"
#include "lab/made_scenes.h"
#include "lab/theory.h"
#include "simulate/response/damping.h"

namespace ballpit {

namespace {

constexpr double kStepsOfContact = 20;  // of springs, where their stiffness follows from the step
constexpr double kFailed = std::numeric_limits<double>::infinity();

Settings with_step(const ContactMethod& method, double dt) {
  Settings settings = method.settings;
  settings.dt = dt;
  return settings;
}

/// One head-on hit of springs, its begin so far into a step.
struct SpringHit {
  double speed, stiffness, restitution, duration;
  std::string law;
};

SpringHit spring_hit(const std::string& law, double restitution) {
  const bool is_hertz = law == "hertz";
  const double v = 1, stiffness = is_hertz ? 1e6 : 1e4, zeta = damping_of(restitution, false);
  return {v, stiffness, restitution,
          is_hertz ? hertz_duration(stiffness, 0.5, v) : contact_duration(stiffness, 0.5, zeta), law};
}

Trial mean_of_hits(const SpringHit& hit, const Settings& settings, int phases) {
  Trial trial{0, 0};
  for (int k = 0; k < phases; ++k) {
    Scene scene = head_on(hit.speed, (2 + (k + 0.5) / phases) * hit.speed * settings.dt);
    scene.physics.law = hit.law;
    scene.physics.stiffness = hit.stiffness;
    scene.physics.restitution = hit.restitution;
    TimedRun run(scene, settings);
    if (!run.reach(2 * hit.duration + 4 * settings.dt)) return {kFailed, run.seconds()};
    const Bodies bodies = run.world().bodies();
    const double parting = bodies.velocity[1].x - bodies.velocity[0].x;
    trial.off += std::fabs(parting / hit.speed - hit.restitution) / phases;
    if (k > 0) trial.seconds += run.seconds() / (phases - 1);  // the first is to warm up
  }
  return trial;
}

double damped() { return restitution_to_overlap_end(0.1); }

Trial run_springs(const ContactMethod& method, double dt, uint64_t, bool) {
  return mean_of_hits(spring_hit("linear", damped()), with_step(method, dt), 64);
}

/// A light sphere meets a heavy one, 0.6 m off its centre: n = (0.8, −0.6), Δp = (1 + e)·μ·(v·n) along it.
Trial run_hit(const ContactMethod& method, double dt, uint64_t, bool) {
  constexpr int kPhases = 8;
  constexpr double kSpeed = 2, kRestitution = 0.6, kMu = 0.75, kTime = 2;
  const Vec3d n(0.8, -0.6, 0), end = Vec3d(kSpeed, 0, 0) - (1 + kRestitution) * kMu * kSpeed * n.x * n;
  Trial trial{0, 0};
  for (int k = 0; k < kPhases; ++k) {
    Scene scene = wide_box();
    scene.physics.restitution = kRestitution;
    scene.physics.stiffness = stiffness_for(dt, kStepsOfContact, kMu, kRestitution);
    add_sphere(scene, {-1.3 - (k + 0.5) / kPhases * kSpeed * dt, 0.6, 0}, {kSpeed, 0, 0}, 0.4, 1);
    add_sphere(scene, {0, 0, 0}, Vec3d(0.0), 0.6, 3);
    TimedRun run(scene, with_step(method, dt));
    if (!run.reach(kTime)) return {kFailed, run.seconds()};
    trial.off += length(run.world().bodies().velocity[0] - end) / kSpeed / kPhases;
    if (k > 0) trial.seconds += run.seconds() / (kPhases - 1);  // the first is to warm up
  }
  return trial;
}

/// Ten spheres that stand on each other: rigid ones do not overlap. Who does not carry their weight is off by infinity.
Trial run_stack(const ContactMethod& method, double dt, uint64_t, bool) {
  constexpr size_t kSpheres = 10;
  constexpr double kRadius = 0.125, kMass = 1, kRest = 2, kWeighing = 0.5, kTolerance = 0.1;
  constexpr int64_t kMostEvents = 20'000;  // in the first hundredth of a second
  Scene scene = make_stack(std::vector<double>(kSpheres, kMass), kRadius);
  scene.physics.stiffness = stiffness_for(dt, kStepsOfContact, kMass / 2, 0);
  Settings settings = with_step(method, dt);
  settings.keeps_tally = true;
  TimedRun run(scene, settings);
  for (const double until : {0.01, kRest}) {
    if (!run.reach(until)) return {kFailed, run.seconds()};
    if (run.world().report().events > kMostEvents) return {kFailed, run.seconds()};  // collisions without end
  }
  const double before = run.world().report().tally.floor_impulse;
  if (!run.reach(kRest + kWeighing)) return {kFailed, run.seconds()};
  const Report report = run.world().report();
  const double weight = (report.tally.floor_impulse - before) / kWeighing;
  const bool is_carried = std::fabs(weight / (kSpheres * kMass * -scene.physics.gravity.y) - 1) < kTolerance;
  return {is_carried ? report.max_overlap : kFailed, run.seconds()};
}

/// Z of 256 hard spheres at the density 0.5.
Trial run_gas(const ContactMethod& method, double dt, uint64_t seed, bool is_quick) {
  constexpr int kCells = 4;
  constexpr double kRho = 0.5, kCount = 256;
  const double time = is_quick ? 10 : 60;
  Scene scene = equilibrium_gas(kCells, kRho, seed);
  scene.physics.stiffness = stiffness_for(dt, kStepsOfContact, 0.5, 1);
  Settings settings = with_step(method, dt);
  settings.keeps_tally = true;
  TimedRun run(scene, settings);
  double kt = 0;  // the mean, over looks
  constexpr int kLooks = 20;
  for (int k = 1; k <= kLooks; ++k) {
    if (!run.reach(time * k / kLooks)) return {kFailed, run.seconds()};
    kt += 2 * run.world().report().kinetic_energy / (3 * (kCount - 1)) / kLooks;
  }
  const double simulated = run.world().time(), virial = run.world().report().tally.virial;
  const double z = 1 + virial / (3 * kCount * kt * simulated), truth = finite_z(kRho, kCount);
  return {(z - truth) / truth, run.seconds()};
}

/// Where 108 spheres at the density 0.1 are after a collision each, against exact motion: the median distance.
Trial run_paths(const ContactMethod& method, double dt, uint64_t seed, bool) {
  constexpr double kTime = 1.25;
  Scene scene = equilibrium_gas(3, 0.1, seed);
  scene.physics.stiffness = stiffness_for(dt, kStepsOfContact, 0.5, 1);
  const auto exact = make_cpu_world(scene, exact_motion(kTime));
  exact->step();
  TimedRun run(scene, with_step(method, dt));
  if (!run.reach(kTime)) return {kFailed, run.seconds()};
  const Bodies truth = exact->bodies(), end = run.world().bodies();
  const Vec3d period = scene.domain.max - scene.domain.min;
  std::vector<double> distances;
  for (size_t i = 0; i < end.position.size(); ++i) {
    const Vec3d d = end.position[i] - truth.position[i];
    distances.push_back(length(d - period * glm::round(d / period)));
  }
  const auto middle = distances.begin() + static_cast<int64_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return {*middle, run.seconds()};
}

bool is_of_springs(const ContactMethod& method) { return method.settings.response == "penalty"; }
bool is_not_the_truth(const ContactMethod& method) { return method.settings.response != "event-driven"; }
bool is_any(const ContactMethod&) { return true; }

}  // namespace

const std::vector<Task>& tasks() {
  static const std::vector<Task> table{
      {"springs", "Damped springs: RK4 keeps two of its four orders", "error of restitution",
       "closed form of the spring-dashpot", spring_hit("linear", damped()).duration / 5, 4, 9, false, is_of_springs,
       run_springs},
      {"hit", "An oblique hit of rigid spheres", "error of velocity / speed", "closed form of rigid spheres", 0.1, 7,
       10, false, is_any, run_hit},
      {"stack", "Ten spheres at rest, one upon the other", "largest overlap / radius",
       "rigid spheres, which carry the weight", 1.0 / 60, 6, 10, false, is_any, run_stack},
      {"gas", "The pressure of a dense gas", "error of Z", "Kolafa et al. 2004, corrected for 256 spheres", 0.04, 3, 5,
       true, is_any, run_gas},
      {"paths", "Where spheres are after a collision each", "median distance / diameter", "exact motion", 1.25 / 16, 5,
       9, false, is_not_the_truth, run_paths},
  };
  return table;
}

double restitution_error(const std::string& integrator, const std::string& precision, const std::string& law,
                         double restitution, double steps, int phases) {
  const SpringHit hit = spring_hit(law, restitution);
  Settings settings = settings_of("penalty", hit.duration / steps, integrator);
  settings.precision = precision;
  return mean_of_hits(hit, settings, phases).off;
}

double order_of_restitution(const std::string& integrator, const std::string& law, double restitution) {
  constexpr int kPhases = 200;
  const auto error = [&](double steps) {
    return restitution_error(integrator, "double", law, restitution, steps, kPhases);
  };
  return std::log2(error(40) / error(160)) / 2;
}

}  // namespace ballpit
