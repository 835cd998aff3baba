// SPDX-License-Identifier: MIT
// Energy and momentum over long runs.
#include <algorithm>
#include <cmath>

#include "core/numbers.h"
#include "lab/charts/key.h"
#include "lab/experiments/contact_methods.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/long_runs.h"
#include "lab/measure/boundary.h"
#include "lab/measure/made_scenes.h"

namespace ballpit {

namespace {

constexpr int kCells = 3;  // 108 spheres
constexpr double kRho = 0.3, kStep = 0.004, kStepsOfContact = 30;
constexpr double kOmegaStep = 0.1;
constexpr int kDoublings = 14;    // of steps
constexpr double kLeast = 1e-14;  // what is less is drawn there

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

std::vector<LargestDrift> gas_drift(Lab& lab, const ContactMethod& method) {
  Settings settings = method.settings;
  settings.dt = kStep;
  const auto key = key_of({"gas", method.name, kStep, kStepsOfContact, double(kCells), kRho, double(lab.seed()),
                           duration(lab.is_quick()), double(times(lab.is_quick()).size())});
  const auto values = lab.measure(key, [&] {
    Scene gas = equilibrium_gas(kCells, kRho, lab.seed());
    gas.physics.stiffness = stiffness_for(kStep, kStepsOfContact, 0.5, 1);
    std::vector<double> flat;
    for (const LargestDrift& drift : drift_of(gas, settings, times(lab.is_quick()))) {
      flat.insert(flat.end(), {drift.energy, drift.momentum});
    }
    return flat;
  });
  std::vector<LargestDrift> drifts;
  for (size_t k = 0; k + 1 < values.size(); k += 2) drifts.push_back({values[k], values[k + 1]});
  return drifts;
}

struct Course {
  ContactMethod method;
  std::vector<LargestDrift> drifts;
};

Table table_of(const std::vector<Course>& courses, const std::vector<double>& at) {
  Table table{"gas", {{"method"}, {"time", "D/√(kT/m)"}, {"energy change"}, {"momentum change"}}, {}};
  for (const Course& course : courses) {
    for (size_t k = 0; k < at.size(); ++k) {
      table.rows.push_back({course.method.name, at[k], course.drifts[k].energy, course.drifts[k].momentum});
    }
  }
  return table;
}

Chart chart_of(const std::string& name, const std::string& title, const std::vector<Course>& courses,
               const std::vector<double>& at, double LargestDrift::*what) {
  Chart chart{name,
              title,
              {"time", "D/√(kT/m)", Scale::log},
              {name + ": largest change so far", "", Scale::log, kLeast / 3, 100},
              {},
              {},
              {}};
  for (const Course& course : courses) {
    Series series = series_of(course.method);
    if (series.is_dashed && !is_float_of_main(course.method)) continue;  // the others are in the table
    for (size_t k = 0; k < at.size(); ++k) {
      series.points.push_back({at[k], std::max(kLeast, course.drifts[k].*what)});
      if (std::isinf(course.drifts[k].*what)) break;  // a run fails once
    }
    chart.series.push_back(series);
  }
  drop_equal_labels(chart.series);
  return chart;
}

Findings oscillator(Lab& lab) {
  Findings findings;
  Table table{"oscillator", {{"integrator"}, {"steps"}, {"largest energy change"}, {"theory"}}, {}};
  Chart chart{"oscillator",
              "On a spring only explicit Euler's energy grows without end",
              {"steps", "", Scale::log},
              {"energy: largest change so far", "", Scale::log},
              {},
              {},
              {}};
  constexpr const char* kRoles[] = {"first", "second", "third", "fourth"};
  int role = 0;
  for (const std::string& name : integrators()) {
    const auto drifts = lab.measure(key_of({"oscillator", name, kOmegaStep, double(kDoublings)}),
                                    [&] { return oscillator_drift(name, kOmegaStep, kDoublings); });
    Series measured{name, kRoles[role++], {}, Stroke::points}, theory{"", "theory", {}, Stroke::line};
    for (int k = 0; k < kDoublings; ++k) {
      const double steps = std::pow(2, k), expected = oscillator_theory(name, kOmegaStep, steps);
      if (expected > kOscillatorLeaves) break;
      table.rows.push_back({name, steps, drifts[static_cast<size_t>(k)], expected});
      measured.points.push_back({steps, drifts[static_cast<size_t>(k)]});
      theory.points.push_back({steps, expected});
    }
    chart.series.insert(chart.series.end(), {theory, measured});
  }
  findings.tables = {table};
  findings.charts = {chart};
  return findings;
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
  for (const ContactMethod& method : contact_methods()) courses.push_back({method, gas_drift(lab, method)});
  Findings findings = oscillator(lab);
  findings.tables.insert(findings.tables.begin(), table_of(courses, at));
  findings.charts.insert(
      findings.charts.begin(),
      {chart_of("energy", "An elastic gas: who keeps its energy", courses, at, &LargestDrift::energy),
       chart_of("momentum", "The same gas: who keeps its momentum", courses, at, &LargestDrift::momentum)});
  findings.answer =
      "Over " + three_digits(at.back()) + " units of time an elastic gas changes its energy by " +
      change(end_of(courses, "penalty, velocity-verlet").energy) + " by velocity Verlet, " +
      change(end_of(courses, "impulse, gauss-seidel").energy) +
      " by impulses with Gauss–Seidel; explicit Euler: " + change(end_of(courses, "penalty, explicit-euler").energy) +
      ".";
  findings.see =
      "Each line is the largest change up to then, of an elastic gas of 108 spheres at the density 0.3, all with "
      "the same step; springs are such that a contact lasts 30 steps. What is below 1e-14 is drawn there. Explicit "
      "Euler gains energy in every contact until the run is stopped (×). Averaging among contacts (Jacobi) and "
      "moving apart by position take energy away. Only the kinematic response loses momentum; all others keep it "
      "to rounding, single precision (dashed) to its own. Thin lines without a label end like their response's "
      "own. The third chart is one mass on a spring, with what theory says of each integrator.";
  return findings;
}

}  // namespace

Experiment drift_experiment() {
  return {
      "drift", "Energy and momentum", "What is left of energy and momentum after a long run?", 15, 150, measurements,
      run};
}

}  // namespace ballpit
