// SPDX-License-Identifier: MIT
// Energy and momentum over long runs.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/numbers.h"
#include "lab/charts/chart_axis.h"
#include "lab/charts/table.h"
#include "lab/experiments/contact_methods.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/long_runs.h"
#include "lab/measure/made_scenes.h"

namespace ballpit {

namespace {

constexpr int kCells = 3;  // 108 spheres
constexpr double kRho = 0.3, kStep = 0.004, kStepsOfContact = 30;
constexpr double kOmegaStep = 0.1;
constexpr int kDoublings = 14;       // of the number of steps
constexpr double kMinDrawn = 1e-14;  // smaller changes are drawn there

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
  Settings settings = method.settings;
  settings.dt = kStep;
  const std::vector<double> at = times(lab.is_quick());
  const auto key =
      key_of("gas", method.name, kStep, kStepsOfContact, kCells, kRho, lab.seed(), duration(lab.is_quick()), at.size());
  const auto values = lab.measure(key, [&] {
    Scene gas = equilibrium_gas(kCells, kRho, lab.seed());
    gas.physics.stiffness = stiffness_for(kStep, kStepsOfContact, 0.5, 1);
    std::vector<double> flat;
    for (const LargestDrift& drift : drift_of(gas, settings, at)) {
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
              Axis{name + ": largest change so far", "", Scale::log, kMinDrawn / 3, 100}};
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
              Axis{"energy: largest change so far", "", Scale::log}};
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

const LargestDrift& end_of(const std::vector<Course>& courses, std::string_view name) {
  return std::find_if(courses.begin(), courses.end(), [&](const Course& c) { return c.method.name == name; })
      ->drifts.back();
}

std::string change(double value) { return std::isinf(value) ? "the run stops" : three_digits(100 * value) + " %"; }

Findings run(Lab& lab) {
  const std::vector<double> at = times(lab.is_quick());
  std::vector<Course> courses;
  for (const ContactMethod& method : contact_methods()) courses.push_back(gas_drift(lab, method));
  Findings findings;
  findings.tables = {table_of(courses, at)};
  findings.charts = {
      chart_of("energy", "An elastic gas: who keeps its energy", courses, at, &LargestDrift::energy),
      chart_of("momentum", "The same gas: who keeps its momentum", courses, at, &LargestDrift::momentum)};
  add_oscillator(lab, findings);
  findings.answer = fmt::format(
      "Over {} units of time an elastic gas changes its energy by {} by velocity Verlet, {} by impulses with "
      "Gauss–Seidel; explicit Euler: {}.",
      three_digits(at.back()), change(end_of(courses, "penalty, velocity-verlet").energy),
      change(end_of(courses, "impulse, gauss-seidel").energy),
      change(end_of(courses, "penalty, explicit-euler").energy));
  findings.see =
      "Each line is the largest change so far, of an elastic gas of 108 spheres with density 0.3, always "
      "with the same step; a contact of springs lasts 30 steps. Changes below 1e-14 are drawn there. "
      "Explicit Euler gains energy in every contact until the guard ends the run (×). Averaging over "
      "contacts (Jacobi) and moving spheres apart by position remove energy. Only the kinematic response "
      "changes momentum; all others keep it up to rounding, in single precision (dashed) up to that "
      "precision. Thin lines without a label end like the main line of their response. The third chart "
      "is one mass on a spring, with the theory of each integrator.";
  return findings;
}

}  // namespace

Experiment drift_experiment() {
  return {
      "drift", "Energy and momentum", "What is left of energy and momentum after a long run?", 15, 150, measurements,
      run};
}

}  // namespace ballpit
