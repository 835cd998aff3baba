// SPDX-License-Identifier: MIT
// Tasks of a few spheres. Each is a mean over contacts that start at different moments of a step.
#include <algorithm>
#include <cmath>

#include "lab/experiments/accuracy.h"
#include "lab/experiments/timed_run.h"
#include "lab/measure/made_scenes.h"
#include "lab/measure/theory.h"
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
    Scene scene = head_on(hit.speed, (2 + phase) * hit.speed * settings.dt);
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
  const auto run = [hit](const ContactMethod& method, double dt, uint64_t, bool) {
    return mean_of_spring_hits(hit, with_step(method, dt), kPhases);
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

Trial run_strike(const Strike& strike, const ContactMethod& method, double dt) {
  constexpr int kPhases = 8;
  const double reach = strike.radius[0] + strike.radius[1], along = std::sqrt(1 - std::pow(strike.offset / reach, 2));
  const double mu = strike.mass[0] * strike.mass[1] / (strike.mass[0] + strike.mass[1]);
  const Vec3d n(along, -strike.offset / reach, 0), v(strike.speed, 0, 0);
  const Vec3d after = v - (1 + strike.restitution) * mu / strike.mass[0] * dot(v, n) * n;
  return mean_over_phases(kPhases, with_step(method, dt), [&](double phase) {
    Scene scene = wide_box();
    scene.physics.restitution = strike.restitution;
    scene.physics.stiffness = stiffness_for(dt, kStepsOfContact, mu, strike.restitution);
    const double start = -(along + 0.5) * reach - phase * strike.speed * dt;
    add_sphere(scene, {start, strike.offset, 0}, v, strike.radius[0], strike.mass[0]);
    add_sphere(scene, {0, 0, 0}, Vec3d(0.0), strike.radius[1], strike.mass[1]);
    return Case{scene, strike.time, [&](const Bodies& end) { return length(end.velocity[0] - after) / strike.speed; }};
  });
}

Task strike_task(const Strike& strike, const std::string& name, const std::string& title, double coarsest) {
  const auto run = [strike](const ContactMethod& method, double dt, uint64_t, bool) {
    return run_strike(strike, method, dt);
  };
  return {name, title, "error of velocity / speed", "closed form of rigid spheres", coarsest, 6, 10, run};
}

/// Dropped from about a metre, observed after three bounces.
Trial run_ball(const ContactMethod& method, double dt, uint64_t, bool) {
  constexpr int kPhases = 4;
  constexpr double kRestitution = 0.8, kTime = 2, kFloor = -2, kRadius = 0.1, kMass = 1;
  return mean_over_phases(kPhases, with_step(method, dt), [&](double phase) {
    Scene scene = wide_box(-kFloor);
    scene.physics.gravity = {0, -9.81, 0};
    scene.physics.restitution = scene.physics.wall_restitution = kRestitution;
    scene.physics.stiffness = stiffness_for(dt, kStepsOfContact, kMass, kRestitution);
    const double height = 0.95 + 0.1 * phase;
    add_sphere(scene, {0, kFloor + kRadius + height, 0}, Vec3d(0.0), kRadius, kMass);
    const double truth = bouncing_height(height, kRestitution, 9.81, kTime);
    return Case{scene, kTime,
                [=](const Bodies& end) { return std::fabs(end.position[0].y - kFloor - kRadius - truth) / height; }};
  });
}

/// Five spheres with gaps, so that one hit follows the other: in the end the last one moves, and all others rest.
Trial run_cradle(const ContactMethod& method, double dt, uint64_t, bool) {
  constexpr int kPhases = 4, kSpheres = 5;
  constexpr double kGap = 0.02, kTime = 0.25;
  return mean_over_phases(kPhases, with_step(method, dt), [&](double phase) {
    Scene scene = wide_box();
    scene.physics.stiffness = stiffness_for(dt, kStepsOfContact, 0.5, 1);
    for (int k = 0; k < kSpheres; ++k) {
      const double x = k == 0 ? -phase * dt : k * (1 + kGap);
      add_sphere(scene, {x, 0, 0}, {k == 0 ? 1.0 : 0.0, 0, 0}, 0.5, 1);
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

}  // namespace

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
  };
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
