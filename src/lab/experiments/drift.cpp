// SPDX-License-Identifier: MIT
// Energy and momentum over long runs.
#include "core/error.h"
#include "lab/experiments/contact_methods.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"

namespace ballpit {

namespace {

constexpr int kCells = 3;  // 108 spheres
constexpr double kRho = 0.3, kStep = 0.004, kStepsOfSpring = 30;
constexpr double kOmegaStep = 0.1;
constexpr int kDoublings = 14;       // of the number of steps
constexpr double kMinDrawn = 1e-14;  // smaller changes are drawn there
constexpr int kStepsBetween = 20;    // checks

double duration(bool is_quick) { return is_quick ? 40 : 400; }

std::vector<double> times(bool is_quick) { return spaced(0.2, duration(is_quick), is_quick ? 16 : 24, Scale::log); }

std::vector<std::string> integrators() {
  std::vector<std::string> names;
  for (const ContactMethod& method : contact_methods()) {
    if (method.settings.response != Response::penalty || method.settings.precision != Precision::float64) continue;
    names.emplace_back(name_of(method.settings.integrator));
  }
  return names;
}

/// A method in the gas, and its drift at each of times().
struct Course {
  ContactMethod method;
  std::vector<LargestDrift> drifts;
};

Course gas_drift(Lab& lab, const ContactMethod& method) {
  const std::vector<double> at = times(lab.is_quick());
  const auto key =
      key_of("gas", method.name, kStep, kStepsOfSpring, kCells, kRho, lab.seed(), duration(lab.is_quick()), at.size());
  const auto values = lab.measure(key, [&] {
    Scene gas = equilibrium_gas(kCells, kRho, lab.seed());
    gas.physics.stiffness = stiffness_for(kStep, kStepsOfSpring, 0.5, 1);
    std::vector<double> flat;
    for (const LargestDrift& drift : drift_of(gas, with_step(method, kStep), at)) {
      flat.insert(flat.end(), {drift.energy, drift.momentum});
    }
    return flat;
  });
  Course course{method, {}};
  for (size_t k = 0; k + 1 < values.size(); k += 2) course.drifts.push_back({values[k], values[k + 1]});
  return course;
}

Table table_of(const std::vector<Course>& courses, const std::vector<double>& at) {
  Table table{"gas", {"method", "time [D/√(kT/m)]", "energy change", "momentum change"}};
  for (const Course& course : courses) {
    for (size_t k = 0; k < at.size(); ++k) {
      table.add_row(course.method.name, at[k], course.drifts[k].energy, course.drifts[k].momentum);
    }
  }
  return table;
}

Chart chart_of(const std::string& name, const std::string& title, const std::vector<Course>& courses,
               const std::vector<double>& at, double LargestDrift::*what) {
  Chart chart{name, title, Axis{"time", "D/√(kT/m)", Scale::log},
              Axis{phrase("{}: largest change so far", translated(name)), "", Scale::log, kMinDrawn / 3, 100}};
  for (const Course& course : courses) {
    Series series = series_of(course.method);
    if (series.is_dashed && !is_float_of_main(course.method)) continue;  // the others are in the table
    for (size_t k = 0; k < at.size(); ++k) {
      series.points.push_back({at[k], std::max(kMinDrawn, course.drifts[k].*what)});
      if (std::isinf(course.drifts[k].*what)) break;  // one cross for each failed run
    }
    chart.series.push_back(series);
  }
  drop_equal_labels(chart.series);
  return chart;
}

/// A mass on a spring: the energy of each integrator against theory.
void add_oscillator(Lab& lab, Findings& findings) {
  Table table{"oscillator", {"integrator", "steps", "largest energy change", "theory"}};
  Chart chart{"oscillator", "On a spring only explicit Euler's energy grows without end", Axis{"steps", "", Scale::log},
              Axis{phrase("{}: largest change so far", translated("energy")), "", Scale::log}};
  constexpr const char* kRoles[] = {"first", "second", "third", "fourth"};
  int role = 0;
  for (const std::string& name : integrators()) {
    const auto drifts = lab.measure(key_of("oscillator", name, kOmegaStep, kDoublings),
                                    [&] { return oscillator_drift(name, kOmegaStep, kDoublings); });
    Series measured{name, kRoles[role++], {}, Stroke::points}, theory{"", "theory", {}, Stroke::line};
    for (size_t k = 0; k < kDoublings; ++k) {
      const double steps = std::exp2(k), expected = oscillator_theory(name, kOmegaStep, steps);
      if (expected > kOscillatorLeaves) break;
      table.add_row(name, steps, drifts[k], expected);
      measured.points.push_back({steps, drifts[k]});
      theory.points.push_back({steps, expected});
    }
    chart.series.insert(chart.series.end(), {theory, measured});
  }
  findings.tables.push_back(table);
  findings.charts.push_back(chart);
}

int64_t measurements(bool) { return static_cast<int64_t>(contact_methods().size() + integrators().size()); }

/// Of a method by name, at the end.
std::string energy_change(const std::vector<Course>& courses, std::string_view name) {
  const auto course = std::ranges::find(courses, name, [](const Course& c) { return c.method.name; });
  const double change = course->drifts.back().energy;
  return std::isinf(change) ? translated("the run stops") : three_digits(100 * change) + " %";
}

Findings measure(Lab& lab) {
  const std::vector<double> at = times(lab.is_quick());
  std::vector<Course> courses;
  for (const ContactMethod& method : contact_methods()) courses.push_back(gas_drift(lab, method));
  Findings findings{
      {table_of(courses, at)},
      {chart_of("energy", "An elastic gas: who keeps its energy", courses, at, &LargestDrift::energy),
       chart_of("momentum", "The same gas: who keeps its momentum", courses, at, &LargestDrift::momentum)},
      {{"time", three_digits(at.back())},
       {"verlet", energy_change(courses, "penalty, velocity-verlet")},
       {"gauss_seidel", energy_change(courses, "impulse, gauss-seidel")},
       {"euler", energy_change(courses, "penalty, explicit-euler")}}};
  add_oscillator(lab, findings);
  return findings;
}

double energy_of(const Report& report) {
  return report.kinetic_energy + report.potential_energy + report.elastic_energy;
}

}  // namespace

std::vector<LargestDrift> drift_of(const Scene& scene, const Settings& settings, const std::vector<double>& times) {
  std::vector<LargestDrift> drifts;
  const auto world = make_world_on_cpu(scene, settings);
  const Report start = world->report();
  double moving = 0;
  for (size_t i = 0; i < scene.bodies.mass.size(); ++i) {
    moving += scene.bodies.mass[i] * length(scene.bodies.velocity[i]);
  }
  LargestDrift drift;
  try {
    for (const double time : times) {
      while (world->time() < time - settings.dt / 2) {
        step_until(*world, std::min(time, world->time() + kStepsBetween * settings.dt), settings.dt);
        const Report now = world->report();
        drift.energy = std::max(drift.energy, std::fabs(energy_of(now) / energy_of(start) - 1));
        drift.momentum = std::max(drift.momentum, length(now.momentum - start.momentum) / moving);
      }
      drifts.push_back(drift);
    }
  } catch (const RunError&) {
    drifts.resize(times.size(), {INFINITY, INFINITY});
  }
  return drifts;
}

std::vector<double> oscillator_drift(const std::string& integrator, double omega_dt, int count) {
  constexpr double kStiffness = 1e4, kGravity = 10,
                   kAmplitude = 1e-4;  // ω = 100/s; at rest the overlap with the floor is 1 mm
  constexpr double kRest = -10 + 0.5 - kGravity / kStiffness;
  Scene scene = wide_box(10);
  scene.physics.gravity = {0, -kGravity, 0};
  scene.physics.stiffness = kStiffness;
  put_sphere(scene, {0, kRest + kAmplitude, 0}, Vec3d(0.0), 0.5, 1.0);
  const auto world = make_world_on_cpu(scene, settings_of("penalty", omega_dt / 100, integrator));
  const double start = 0.5 * kStiffness * kAmplitude * kAmplitude;
  std::vector<double> drifts;
  double largest = 0;
  for (int k = 0; k < count; ++k) {
    while (world->steps() < (int64_t{1} << k)) {
      world->step();
      const Bodies bodies = world->bodies();
      const double y = bodies.position[0].y - kRest, v = bodies.velocity[0].y;
      largest = std::max(largest, std::fabs((0.5 * v * v + 0.5 * kStiffness * y * y) / start - 1));
    }
    drifts.push_back(largest);
  }
  return drifts;
}

double oscillator_theory(const std::string& integrator, double omega_dt, double steps) {
  const double z = omega_dt;
  if (integrator == "explicit-euler") return std::pow(1 + z * z, steps) - 1;
  if (integrator == "velocity-verlet") return z * z / 4;
  if (integrator == "symplectic-euler") return z / (2 - z);
  return 1 - std::pow(1 - std::pow(z, 6) / 72 + std::pow(z, 8) / 576, steps);
}

Experiment drift_experiment() { return {"drift", 15, 150, measurements, measure}; }

}  // namespace ballpit
