// SPDX-License-Identifier: MIT
// A gas that loses energy in each collision: Haff's law.

#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"
#include "measure/theory.h"

namespace ballpit {

namespace {

constexpr double kRho = 0.1;
constexpr int kCells = 4;  // 256 spheres; in larger gases clusters form
const std::vector<double> kRestitutions{0.95, 0.9, 0.8};

/// [τ] rounded to hundredths
std::vector<double> times() {
  std::vector<double> result = spaced(0.1, 10, 17, Scale::log);
  for (double& time : result) time = std::round(100 * time) / 100;
  return result;
}

int seeds(bool is_quick) { return is_quick ? 20 : 200; }

/// The results of one restitution: T/T₀ at each time, and τ over that of Haff's law, from the time at which T is a
/// quarter.
struct Course {
  double restitution;
  std::vector<Mean> temperature;
  Mean tau;
};

Course course_of(Lab& lab, double restitution) {
  const std::vector<double> at = times();
  std::vector<std::vector<double>> parts(at.size());
  std::vector<double> taus;
  for (int k = 0; k < seeds(lab.is_quick()); ++k) {
    const GasRun run{kCells, kRho, lab.seed() * 1000 + static_cast<uint64_t>(k), 0, 0};
    const auto key = key_of("cooling", restitution, run.cells, run.rho, run.seed, at.size());
    const auto one = lab.measure(key, [&] { return cooling(run, restitution, at); });
    for (size_t t = 0; t < at.size(); ++t) parts[t].push_back(one[t]);
    const size_t middle = at.size() / 2;  // √(T₀/T) = 1 + t/τ at t = τ
    taus.push_back(at[middle] / (1 / std::sqrt(one[middle]) - 1));
  }
  Course course{restitution, {}, mean_of(taus)};
  for (const auto& values : parts) course.temperature.push_back(mean_of(values));
  return course;
}

double haff(double time) { return std::pow(1 + time, -2); }

std::vector<Table> tables_of(const std::vector<Course>& courses) {
  Table temperature{"temperature", {"restitution", "time [τ]", "T/T₀", "standard error", "Haff's law"}};
  Table tau{"tau", {"restitution", "τ, of Haff's", "standard error"}, {}, true};
  const std::vector<double> at = times();
  for (const Course& course : courses) {
    for (size_t t = 0; t < at.size(); ++t) {
      const Mean& mean = course.temperature[t];
      temperature.add_row(course.restitution, at[t], mean.value, mean.error, haff(at[t]));
    }
    tau.add_row(course.restitution, course.tau.value, course.tau.error);
  }
  return {temperature, tau};
}

std::string label_of(const Course& course) { return "e = " + key_of(course.restitution); }

std::vector<Chart> charts_of(const std::vector<Course>& courses) {
  constexpr const char* kRoles[] = {"first", "second", "third"};
  const std::vector<double> at = times(), xs = spaced(at.front(), at.back(), 60, Scale::log);
  const Axis time{"time t/τ", "", Scale::log};
  Chart whole{"temperature", "A gas cools by (1 + t/τ)⁻²", time, Axis{"T/T₀", "", Scale::log}};
  Chart detail{"deviation", "How far the temperature is from Haff's law", time, {"deviation of T", "%"}};
  whole.series = {theory_line("Haff's law", xs, haff)};
  detail.series = {theory_line("Haff's law", xs, [](double) { return 0.0; })};
  for (size_t k = 0; k < courses.size(); ++k) {
    Series points{label_of(courses[k]), kRoles[k], {}, Stroke::points}, off{points.label, points.role, {}};
    for (size_t t = 0; t < at.size(); ++t) {
      const Mean& mean = courses[k].temperature[t];
      points.points.push_back(point_of(at[t], mean));
      off.points.push_back(point_of(at[t], Mean{100 * (mean.value / haff(at[t]) - 1), 100 * mean.error / haff(at[t])}));
    }
    whole.series.push_back(points);
    detail.series.push_back(off);
  }
  return {whole, detail};
}

int64_t measurements(bool is_quick) { return static_cast<int64_t>(kRestitutions.size()) * seeds(is_quick); }

Findings measure(Lab& lab) {
  std::vector<Course> courses;
  for (const double restitution : kRestitutions) courses.push_back(course_of(lab, restitution));
  const Course& first = courses[1];
  return {tables_of(courses),
          charts_of(courses),
          {{"gas", label_of(first)},
           {"off", three_digits(100 * (first.tau.value - 1))},
           {"error", three_digits(100 * first.tau.error)}}};
}

}  // namespace

std::vector<double> cooling(const GasRun& run, double restitution, const std::vector<double>& times) {
  Scene scene = equilibrium_gas(run.cells, run.rho, run.seed);
  scene.physics.restitution = restitution;
  const double tau = cooling_time(run.rho, count_of(run), restitution);
  Settings settings = exact_motion(tau / 100);
  std::vector<double> parts;
  const auto world = make_world_on_cpu(scene, settings);
  const double start = world->report().kinetic_energy;
  for (const double time : times) {
    step_until(*world, time * tau, settings.dt);
    parts.push_back(world->report().kinetic_energy / start);
  }
  return parts;
}

Experiment cooling_experiment() { return {"cooling", 5, 50, measurements, measure}; }

}  // namespace ballpit
