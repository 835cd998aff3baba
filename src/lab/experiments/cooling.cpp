// SPDX-License-Identifier: MIT
// A gas that loses energy in each collision: Haff's law.
#include <algorithm>
#include <cmath>

#include "core/numbers.h"
#include "lab/charts/key.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/hard_spheres.h"
#include "lab/measure/boundary.h"
#include "lab/measure/mean.h"

namespace ballpit {

namespace {

constexpr double kRho = 0.1;
constexpr int kCells = 4;  // 256 spheres: so few stay evenly spread
const std::vector<double> kRestitutions{0.95, 0.9, 0.8};

/// [τ], in hundredths.
std::vector<double> times() {
  std::vector<double> result = spaced(0.1, 10, 17, Scale::log);
  for (double& time : result) time = std::round(100 * time) / 100;
  return result;
}

int seeds(bool is_quick) { return is_quick ? 20 : 200; }

/// What one restitution shows: T/T₀ at each time, and τ by the time when T has fallen to a quarter, of Haff's.
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
    const auto key = key_of({"cooling", restitution, double(run.cells), run.rho, double(run.seed), double(at.size())});
    const auto one = lab.measure(key, [&] { return cooling(run, restitution, at); });
    for (size_t t = 0; t < at.size(); ++t) parts[t].push_back(one[t]);
    const size_t middle = at.size() / 2;  // √(T₀/T) = 1 + t/τ at t = τ
    taus.push_back(at[middle] / (1 / std::sqrt(one[middle]) - 1));
  }
  Course course{restitution, {}, mean_of(taus)};
  for (const auto& values : parts) course.temperature.push_back(mean_of(values));
  return course;
}

Table table_of(const std::vector<Course>& courses) {
  Table table{"temperature", {{"restitution"}, {"time", "τ"}, {"T/T₀"}, {"standard error"}, {"Haff's law"}}, {}};
  const std::vector<double> at = times();
  for (const Course& course : courses) {
    for (size_t t = 0; t < at.size(); ++t) {
      const Mean& mean = course.temperature[t];
      table.rows.push_back({course.restitution, at[t], mean.value, mean.error, std::pow(1 + at[t], -2)});
    }
  }
  return table;
}

Table tau_table(const std::vector<Course>& courses) {
  Table table{"tau", {{"restitution"}, {"τ, of Haff's"}, {"standard error"}}, {}, true};
  for (const Course& course : courses) table.rows.push_back({course.restitution, course.tau.value, course.tau.error});
  return table;
}

std::string label_of(const Course& course) { return "e = " + key_of({course.restitution}); }

std::vector<Chart> charts_of(const std::vector<Course>& courses) {
  constexpr const char* kRoles[] = {"first", "second", "third"};
  const std::vector<double> at = times();
  const Axis time{"time t/τ", "", Scale::log};
  Chart whole{"temperature", "A gas cools by (1 + t/τ)⁻²", time, {"T/T₀", "", Scale::log}, {}, {}, {}};
  Chart detail{"deviation", "How far the temperature is from Haff's law", time, {"deviation of T", "%"}, {}, {}, {}};
  Series law{"Haff's law", "theory", {}, Stroke::line}, zero = law;
  for (const double t : spaced(at.front(), at.back(), 60, Scale::log)) {
    law.points.push_back({t, std::pow(1 + t, -2)});
    zero.points.push_back({t, 0});
  }
  whole.series = {law};
  detail.series = {zero};
  for (size_t k = 0; k < courses.size(); ++k) {
    Series points{label_of(courses[k]), kRoles[k], {}, Stroke::points}, off = points;
    off.stroke = Stroke::line_and_points;
    for (size_t t = 0; t < at.size(); ++t) {
      const Mean& mean = courses[k].temperature[t];
      const double haff = std::pow(1 + at[t], -2);
      points.points.push_back({at[t], mean.value, mean.value - mean.error, mean.value + mean.error});
      const double value = 100 * (mean.value / haff - 1), error = 100 * mean.error / haff;
      off.points.push_back({at[t], value, value - error, value + error});
    }
    whole.series.push_back(points);
    detail.series.push_back(off);
  }
  return {whole, detail};
}

int64_t measurements(bool is_quick) { return static_cast<int64_t>(kRestitutions.size()) * seeds(is_quick); }

Findings run(Lab& lab) {
  std::vector<Course> courses;
  for (const double restitution : kRestitutions) courses.push_back(course_of(lab, restitution));
  Findings findings;
  findings.tables = {table_of(courses), tau_table(courses)};
  findings.charts = charts_of(courses);
  const Course& first = courses[1];
  findings.answer = "A gas with " + label_of(first) + " cools by Haff's law: its τ is off by " +
                    three_digits(100 * (first.tau.value - 1)) + " ± " + three_digits(100 * first.tau.error) +
                    " % from that of kinetic theory.";
  findings.see =
      "T/T₀ of gases of 256 spheres by exact motion, means over seeds with their standard errors; time in units of "
      "τ = 6/((1 − e²)·Γ₀), which follows from the collision rate at the start. Nothing is fitted. The second "
      "chart magnifies the first: the more a collision takes, the less the speeds are Maxwell's, and the law is a "
      "little off.";
  return findings;
}

}  // namespace

Experiment cooling_experiment() {
  return {"cooling", "Cooling", "Does a gas that loses energy cool by Haff's law?", 5, 50, measurements, run};
}

}  // namespace ballpit
