// SPDX-License-Identifier: MIT
// The table of tasks, and the tasks of a few spheres: contacts, each a mean over moments of a step at which they start,
// and piles at rest. Rigid spheres do not overlap.
#include "lab/experiments/accuracy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/measure/made_scenes.h"
#include "measure/theory.h"
#include "response/pair_force.h"

namespace ballpit {

namespace {

/// A scene, the time until which it runs, and the error of its end.
struct Case {
  Scene scene;
  double time;  ///< [s]
  std::function<double(const Bodies& end)> off;
};

/// The mean over `phases` cases, the first of which is not timed; kFailed if one of them stops.
Trial mean_over_phases(int phases, const Settings& settings, const std::function<Case(double phase)>& make) {
  Trial trial{0, 0};
  for (int k = 0; k < phases; ++k) {
    const Case one = make((k + 0.5) / phases);
    TimedRun run(one.scene, settings);
    if (!run.reach(one.time)) return {kFailed, run.seconds()};
    trial.off += one.off(run.world().bodies()) / phases;
    if (k > 0) trial.seconds += run.seconds() / (phases - 1);
  }
  return trial;
}

/// A head-on hit of springs whose stiffness does not depend on the step.
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

Trial mean_of_spring_hits(const SpringHit& hit, const Settings& settings, int phases) {
  return mean_over_phases(phases, settings, [&](double phase) {
    Scene scene = wide_box();
    const double gap = (2 + phase) * hit.speed * settings.dt;
    for (const int side : {-1, 1}) {
      put_sphere(scene, {side * (0.5 + gap / 2), 0, 0}, {-side * hit.speed / 2, 0, 0}, 0.5, 1);
    }
    scene.physics.law = hit.law;
    scene.physics.stiffness = hit.stiffness;
    scene.physics.restitution = hit.restitution;
    return Case{scene, 2 * hit.duration + 4 * settings.dt, [&hit](const Bodies& end) {
                  return std::fabs((end.velocity[1].x - end.velocity[0].x) / hit.speed - hit.restitution);
                }};
  });
}

Task springs_of(const SpringHit& hit, const std::string& name, const std::string& title, const std::string& truth) {
  constexpr int kPhases = 32;
  const auto run = [hit](const Settings& settings, uint64_t, bool) {
    return mean_of_spring_hits(hit, settings, kPhases);
  };
  const auto has_springs = [](const ContactMethod& method) { return method.settings.response == Response::penalty; };
  return {name, title, "error of restitution", truth, hit.duration / 5, 4, 9, run, false, has_springs};
}

/// One sphere hits another at rest, `offset` beside its centre. Along the line n of centres Δp = (1 + e)·μ·(v·n).
struct Strike {
  double speed, restitution, offset;
  double radius[2], mass[2];
  double time;
};

Trial run_strike(const Strike& strike, const Settings& settings) {
  constexpr int kPhases = 8;
  const double reach = strike.radius[0] + strike.radius[1], along = std::sqrt(1 - std::pow(strike.offset / reach, 2));
  const double mu = strike.mass[0] * strike.mass[1] / (strike.mass[0] + strike.mass[1]);
  const Vec3d n(along, -strike.offset / reach, 0), v(strike.speed, 0, 0);
  const Vec3d after = v - (1 + strike.restitution) * mu / strike.mass[0] * dot(v, n) * n;
  return mean_over_phases(kPhases, settings, [&](double phase) {
    Scene scene = wide_box();
    scene.physics.restitution = strike.restitution;
    scene.physics.stiffness = stiffness_for(settings.dt, kStepsOfContact, mu, strike.restitution);
    const double start = -(along + 0.5) * reach - phase * strike.speed * settings.dt;
    put_sphere(scene, {start, strike.offset, 0}, v, strike.radius[0], strike.mass[0]);
    put_sphere(scene, {0, 0, 0}, Vec3d(0.0), strike.radius[1], strike.mass[1]);
    return Case{scene, strike.time, [&](const Bodies& end) { return length(end.velocity[0] - after) / strike.speed; }};
  });
}

Task strike_task(const Strike& strike, const std::string& name, const std::string& title, double coarsest) {
  const auto run = [strike](const Settings& settings, uint64_t, bool) { return run_strike(strike, settings); };
  return {name, title, "error of velocity / speed", "closed form of rigid spheres", coarsest, 6, 10, run};
}

/// Dropped from about a metre, observed after three bounces.
Trial run_ball(const Settings& settings, uint64_t, bool) {
  constexpr int kPhases = 4;
  constexpr double kRestitution = 0.8, kTime = 2, kFloor = -2, kRadius = 0.1, kMass = 1;
  return mean_over_phases(kPhases, settings, [&](double phase) {
    Scene scene = wide_box(-kFloor);
    scene.physics.gravity = {0, -9.81, 0};
    scene.physics.restitution = scene.physics.wall_restitution = kRestitution;
    scene.physics.stiffness = stiffness_for(settings.dt, kStepsOfContact, kMass, kRestitution);
    const double height = 0.95 + 0.1 * phase;
    put_sphere(scene, {0, kFloor + kRadius + height, 0}, Vec3d(0.0), kRadius, kMass);
    const double truth = bouncing_height(height, kRestitution, 9.81, kTime);
    return Case{scene, kTime,
                [=](const Bodies& end) { return std::fabs(end.position[0].y - kFloor - kRadius - truth) / height; }};
  });
}

/// Five spheres with gaps, so that one hit follows the other: in the end the last one moves, and all others rest.
Trial run_cradle(const Settings& settings, uint64_t, bool) {
  constexpr int kPhases = 4, kSpheres = 5;
  constexpr double kGap = 0.02, kTime = 0.25;
  return mean_over_phases(kPhases, settings, [&](double phase) {
    Scene scene = wide_box();
    scene.physics.stiffness = stiffness_for(settings.dt, kStepsOfContact, 0.5, 1);
    for (int k = 0; k < kSpheres; ++k) {
      const double x = k == 0 ? -phase * settings.dt : k * (1 + kGap);
      put_sphere(scene, {x, 0, 0}, {k == 0 ? 1.0 : 0.0, 0, 0}, 0.5, 1);
    }
    return Case{scene, kTime, [](const Bodies& end) {
                  double largest = std::fabs(end.velocity.back().x - 1);
                  for (size_t k = 0; k + 1 < end.velocity.size(); ++k) {
                    largest = std::max(largest, std::fabs(end.velocity[k].x));
                  }
                  return largest;
                }};
  });
}

/// The largest overlap at rest; a method fails if the floor does not carry the weight. Steps are no finer than 0.13 ms:
/// below that, single precision loses gravity's part in a step, and impulses sink into the allowed overlap for longer
/// than this waits.
Trial run_pile(const std::vector<double>& masses, Settings settings) {
  constexpr double kRadius = 0.125, kRest = 1.5, kWeighing = 0.25, kTolerance = 0.1;
  constexpr int64_t kMaxEvents = 20'000;  // more are an endless series of collisions
  Scene scene = make_stack(masses, kRadius);
  const double lightest = *std::min_element(masses.begin(), masses.end());
  scene.physics.stiffness = stiffness_for(settings.dt, kStepsOfContact, lightest / 2, 0);
  settings.keeps_tally = true;
  TimedRun run(scene, settings);
  for (const double until : {0.01, kRest}) {
    if (!run.reach(until) || run.world().report().events > kMaxEvents) return {kFailed, run.seconds()};
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
  const auto run = [masses](const Settings& settings, uint64_t, bool) { return run_pile(masses, settings); };
  return {name, title, "largest overlap / radius", "rigid spheres, which carry the weight", 1.0 / 60, quick_halvings,
          7,    run};
}

std::vector<double> equal(size_t count) { return std::vector<double>(count, 1.0); }

std::vector<Task> contact_tasks() {
  return {
      springs_of(spring_hit("linear", restitution_to_overlap_end(0.1)), "springs",
                 "Damped springs: RK4 keeps two of its four orders", "closed form of the spring-dashpot"),
      springs_of(spring_hit("hertz", 1), "hertz", "Springs by Hertz’s law: no order above 2.5",
                 "energy, which undamped springs keep"),
      {"ball", "A ball after three bounces", "error of height / first height", "closed form of parabolas", 1.0 / 30, 5,
       9, run_ball},
      strike_task({2, 0.6, 0.6, {0.4, 0.6}, {1, 3}, 1}, "hit", "An oblique hit of rigid spheres", 0.1),
      strike_task({20, 1, 0, {0.05, 0.1}, {0.1, 1}, 0.2}, "bullet", "A bullet that coarse steps carry past its aim",
                  0.02),
      {"cradle", "Newton’s cradle, with gaps", "largest error of velocity / speed", "one hit after another", 0.05, 6,
       10, run_cradle},
      pile(equal(5), "stack-5", "Five spheres at rest, one upon the other", 5),
      pile(equal(10), "stack-10", "Ten spheres at rest, one upon the other", 6),
      pile(equal(20), "stack-20", "Twenty spheres at rest, one upon the other", 5),
      pile({1, 100}, "mass-ratio", "A sphere a hundred times as heavy upon a light one", 6),
  };
}

}  // namespace

const std::vector<Task>& tasks() {
  static const std::vector<Task> table = [] {
    std::vector<Task> all = contact_tasks();
    std::ranges::move(gas_tasks(), std::back_inserter(all));
    return all;
  }();
  return table;
}

double order_of_restitution(const std::string& integrator, const std::string& law, double restitution) {
  constexpr int kPhases = 200;
  const SpringHit hit = spring_hit(law, restitution);
  const auto error = [&](double steps) {
    return mean_of_spring_hits(hit, settings_of("penalty", hit.duration / steps, integrator), kPhases).off;
  };
  return std::log2(error(40) / error(160)) / 2;
}

}  // namespace ballpit
