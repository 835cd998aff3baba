// SPDX-License-Identifier: MIT
// Tasks of many collisions. Gases are chaotic: after a few collisions of each sphere, only means can be compared.
#include <algorithm>
#include <cmath>
#include <optional>

#include "lab/experiments/accuracy.h"
#include "lab/measure/made_scenes.h"
#include "measure/theory.h"

namespace ballpit {

namespace {

constexpr int kCells = 3;  // 108 spheres
constexpr double kCount = 4.0 * kCells * kCells * kCells;

/// A task's run, which starts from a scene for its seed. The last scene is kept, since all methods of a repeat start
/// from it.
using Run = std::function<Trial(const Scene&, const Settings&, bool is_quick)>;

decltype(Task::run) from(const std::function<Scene(uint64_t seed)>& make, const Run& run) {
  std::optional<uint64_t> made;
  return [make, run, made, start = Scene()](const Settings& settings, uint64_t seed, bool is_quick) mutable {
    if (made != seed) start = make(seed);
    made = seed;
    return run(start, settings, is_quick);
  };
}

std::function<Scene(uint64_t)> gas_of(double rho, double collisions = kCollisionsToEquilibrium) {
  return [=](uint64_t seed) { return equilibrium_gas(kCells, rho, seed, collisions); };
}

/// The mean of a value, sampled at equal intervals between these times; NaN if the run stops.
double mean_of_samples(TimedRun& run, double from, double to, const std::function<double(World&)>& value) {
  constexpr int kSamples = 40;
  double sum = 0;
  if (!run.reach(from)) return kNoNumber;
  for (int k = 1; k <= kSamples; ++k) {
    if (!run.reach(from + (to - from) * k / kSamples)) return kNoNumber;
    sum += value(run.world());
  }
  return sum / kSamples;
}

Trial trial_of(double value, double truth, const TimedRun& run) {
  return {std::isnan(value) ? kFailed : value / truth - 1, run.seconds()};
}

/// Z = 1 + W/(3·N·kT·t) with the virial W of all collisions.
Trial run_pressure(const Scene& scene, double rho, double time, Settings settings) {
  settings.keeps_tally = true;
  TimedRun run(with_springs(scene, settings.dt), settings);
  const double kt = mean_of_samples(
      run, 0, time, [](World& world) { return 2 * world.report().kinetic_energy / (3 * (kCount - 1)); });
  const double virial = run.world().report().tally.virial;
  return trial_of(1 + virial / (3 * kCount * kt * run.world().time()), finite_z(rho, kCount), run);
}

Task pressure_task(const std::function<Scene(uint64_t)>& gas, double rho, const std::string& name,
                   const std::string& title, double coarsest, double time, int quick_halvings, int full_halvings) {
  const Run run = [=](const Scene& scene, const Settings& settings, bool is_quick) {
    return run_pressure(scene, rho, is_quick ? time / 4 : time, settings);
  };
  const std::string truth = "Kolafa et al. 2004, corrected for 108 spheres";
  return {name, title, "error of Z", truth, coarsest, quick_halvings, full_halvings, from(gas, run), true};
}

/// The median distance between the positions after a time and those of exact motion.
Trial run_paths(const Scene& scene, double time, const Settings& settings) {
  const auto exact = make_world_on_cpu(scene, exact_motion(time));
  exact->step();
  TimedRun run(with_springs(scene, settings.dt), settings);
  if (!run.reach(time)) return {kFailed, run.seconds()};
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

Task paths_task(double rho, const std::string& name, const std::string& title) {
  constexpr double kCollisions = 2;  // of each sphere; in each, errors grow by a factor of e^0.8 to e^2.5
  const double time = kCollisions / collision_rate(rho, kCount);
  const Run run = [=](const Scene& scene, const Settings& settings, bool) { return run_paths(scene, time, settings); };
  return {name, title, "median distance / diameter", "exact motion", time / 16,
          5,    10,    from(gas_of(rho), run),       false,          has_steps};
}

constexpr double kEnergyRho = 0.5, kCoolingRho = 0.1;

/// |E/E₀ − 1| of an elastic gas, divided by the number of collisions of a sphere.
Trial run_energy(const Scene& scene, const Settings& settings, bool is_quick) {
  const double collisions = is_quick ? 10 : 40, time = collisions / collision_rate(kEnergyRho, kCount);
  TimedRun run(with_springs(scene, settings.dt), settings);
  const auto energy = [&] {
    const Report report = run.world().report();
    return report.kinetic_energy + report.elastic_energy;
  };
  const double start = energy();
  if (!run.reach(time)) return {kFailed, run.seconds()};
  return {std::fabs(energy() / start - 1) / collisions, run.seconds()};
}

/// T/T₀ after the time τ of Haff's law: about a quarter.
Trial run_cooling(Scene scene, const Settings& settings, bool) {
  constexpr double kRestitution = 0.9;
  scene.physics.restitution = kRestitution;
  scene.physics.stiffness = stiffness_for(settings.dt, kStepsOfContact, 0.5, kRestitution);
  TimedRun run(scene, settings);
  const double start = run.world().report().kinetic_energy;
  const double tau = cooling_time(kCoolingRho, kCount, kRestitution);
  if (!run.reach(tau)) return {kFailed, run.seconds()};
  return trial_of(run.world().report().kinetic_energy / start, std::pow(1 + run.world().time() / tau, -2), run);
}

/// The mean height of a gas under gravity, for its energy, which is constant while its temperature is not.
Trial run_column(const Scene& scene, const Settings& settings, bool is_quick) {
  TimedRun run(with_springs(scene, settings.dt), settings);
  const Report start = run.world().report();
  const auto count = static_cast<double>(scene.bodies.size());
  const double radius = scene.bodies.radius[0], weight = -scene.physics.gravity.y;
  const auto height = [&](const Bodies& bodies) {
    double sum = 0;
    for (const Vec3d& x : bodies.position) sum += x.y - scene.domain.min.y - radius;
    return sum / count;
  };
  const double energy = start.kinetic_energy / count + weight * height(scene.bodies);
  const double mean = mean_of_samples(run, 0, is_quick ? 10 : 40, [&](World& world) { return height(world.bodies()); });
  const Vec3d room = scene.domain.max - scene.domain.min - Vec3d(2 * radius);
  return trial_of(mean, barometric_height(energy, weight, 2 * radius, count / (room.x * room.z)), run);
}

/// Large spheres and small ones, which are too slow at first.
Scene uneven_mixture(uint64_t seed) {
  Scene scene = equilibrium_mixture(kCells, seed);
  for (size_t i = 1; i < scene.bodies.velocity.size(); i += 2) scene.bodies.velocity[i] *= 0.5;
  stop_center(scene.bodies);
  return scene;
}

/// The share of the energy that the small spheres reach. With total momentum 0 and mass M, a sphere of mass m has a
/// share in proportion to 1 − m/M.
Trial run_mixture(Scene scene, const Settings& settings, bool is_quick) {
  constexpr double kSettle = 5;
  const double large = scene.bodies.mass[0], small = scene.bodies.mass[1], all = kCount / 2 * (small + large);
  scene.physics.stiffness = stiffness_for(settings.dt, kStepsOfContact, small / 2, 1);
  TimedRun run(scene, settings);
  const double share = mean_of_samples(run, kSettle, kSettle + (is_quick ? 5 : 20), [&](World& world) {
    const Bodies bodies = world.bodies();
    double energy[2] = {0, 0};
    for (size_t i = 0; i < bodies.position.size(); ++i) {
      energy[i % 2] += bodies.mass[i] * dot(bodies.velocity[i], bodies.velocity[i]);
    }
    return energy[1] / (energy[0] + energy[1]);
  });
  return trial_of(share, (1 - small / all) / (2 - (small + large) / all), run);
}

}  // namespace

std::vector<Task> gas_tasks() {
  return {
      pressure_task(gas_of(0.1), 0.1, "gas-thin", "The pressure of a thin gas", 0.08, 40, 3, 5),
      pressure_task(gas_of(0.5), 0.5, "gas", "The pressure of a dense gas", 0.04, 40, 3, 5),
      pressure_task(gas_of(0.8, 1000), 0.8, "gas-dense", "The pressure of a very dense gas", 0.016, 20, 2, 4),
      paths_task(0.1, "paths-thin", "A thin gas: where spheres are after two collisions each"),
      paths_task(0.5, "paths", "A dense gas: where spheres are after two collisions each"),
      {"energy", "A dense gas that should keep its energy", "energy change in a sphere’s collision",
       "energy at the start", 0.04, 3, 6, from(gas_of(kEnergyRho), run_energy)},
      {"cooling", "A gas that cools", "error of temperature", "Haff’s law", 0.08, 1, 4,
       from(gas_of(kCoolingRho), run_cooling), true},
      {"column", "A gas under gravity", "error of mean height", "barometric formula, second virial coefficient", 0.08,
       3, 5, from(equilibrium_column, run_column), true},
      {"mixture", "Small spheres and large ones share their energy", "error of the small ones’ share",
       "equipartition at zero momentum", 0.08, 2, 4, from(uneven_mixture, run_mixture), true},
  };
}

}  // namespace ballpit
