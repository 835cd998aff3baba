// SPDX-License-Identifier: MIT
// The axis of sort and sweep: along the height of a tall box few intervals overlap, along that of a flat box nearly
// all. Candidates for each axis against the formula, and the fastest broad phase for each shape of the box.

#include "lab/experiments/experiments.h"
#include "lab/experiments/winner_map.h"
#include "world/world.h"

namespace ballpit {

namespace {

const std::vector<std::string> kAxes{"x", "z", "auto"};  // y is like x: the box is square

std::vector<double> aspects(bool is_quick) {
  if (is_quick) return {0.01, 0.1, 1, 10, 100};
  return {0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 100, 300, 1000};
}

WinnerPlan plan_of(bool is_quick) {
  return {"Fastest broad phase by the box’s shape",
          "aspect",
          Axis{"height of the box over its width", "", Scale::log},
          aspects(is_quick),
          winner_counts(is_quick),
          [](int64_t count, double aspect, uint64_t seed) {
            return uniform_spheres({count, 0.3, 1, aspect}, seed);
          }};
}

int64_t swept_count(bool is_quick) { return is_quick ? 10'000 : 30'000; }

double candidates_along(const std::string& axis, const UniformSpheres& spheres, uint64_t seed) {
  Settings settings = search_by("sort-and-sweep");
  settings.axis = named<SweepAxis>(axis);
  const auto search = cpu_backend().make_pair_search(settings);
  const SphereSet set = uniform_spheres(spheres, seed);
  search->find(set.arrays());
  return static_cast<double>(search->report().candidates);
}

int64_t measurements(bool is_quick) {
  return winner_measurements(plan_of(is_quick)) + static_cast<int64_t>(kAxes.size() * aspects(is_quick).size());
}

struct Sweep {
  double aspect, expected_x, expected_z;
  std::vector<double> candidates;  ///< for each of kAxes
};

std::vector<Sweep> measure_sweeps(Lab& lab) {
  std::vector<Sweep> sweeps;
  for (const double aspect : aspects(lab.is_quick())) {
    const UniformSpheres spheres{swept_count(lab.is_quick()), 0.3, 1, aspect};
    const Vec3d box = box_of(spheres);
    Sweep sweep{
        aspect, expected_interval_overlaps(spheres.count, box.x), expected_interval_overlaps(spheres.count, box.z), {}};
    for (const std::string& axis : kAxes) {
      const std::string key = fmt::format("candidates of sort and sweep along {}; {} spheres; aspect {}; seed {}", axis,
                                          spheres.count, number_text(aspect), lab.seed());
      sweep.candidates.push_back(lab.measure_number(key, [&] { return candidates_along(axis, spheres, lab.seed()); }));
    }
    sweeps.push_back(std::move(sweep));
  }
  return sweeps;
}

Chart sweep_chart(const WinnerPlan& plan, const std::vector<Sweep>& sweeps, int64_t count) {
  const auto series = [&](const char* label, const char* role, Stroke stroke, const auto& value) {
    const auto to_point = [&](const Sweep& s) { return Point{s.aspect, value(s) / static_cast<double>(count)}; };
    return make_series(label, role, stroke, sweeps, to_point);
  };
  return {"candidates",
          phrase("Candidates of sort and sweep, {} spheres", grouped(count)),
          plan.axis,
          Axis{"candidates a sphere", "", Scale::log},
          {series("", "theory", Stroke::line, [](const Sweep& s) { return s.expected_x; }),
           series("", "theory", Stroke::line, [](const Sweep& s) { return s.expected_z; }),
           series("along x", "second", Stroke::points, [](const Sweep& s) { return s.candidates[0]; }),
           series("along z", "third", Stroke::points, [](const Sweep& s) { return s.candidates[1]; }),
           series("auto", "sort-and-sweep", Stroke::line_and_points, [](const Sweep& s) { return s.candidates[2]; })}};
}

Table sweep_table(const std::vector<Sweep>& sweeps, int64_t count) {
  Table table{"sweeps",
              {"spheres", "height over width", "candidates along x", "expected along x", "candidates along z",
               "expected along z", "candidates by auto"}};
  for (const Sweep& s : sweeps) {
    table.add_row(count, s.aspect, s.candidates[0], s.expected_x, s.candidates[1], s.expected_z, s.candidates[2]);
  }
  return table;
}

Findings measure(Lab& lab) {
  const WinnerPlan plan = plan_of(lab.is_quick());
  const std::vector<Sweep> sweeps = measure_sweeps(lab);
  const int64_t count = swept_count(lab.is_quick());
  Findings findings = winner_findings(plan, find_winners(lab, plan));
  findings.tables.push_back(sweep_table(sweeps, count));
  findings.charts.insert(findings.charts.begin(), sweep_chart(plan, sweeps, count));
  const Sweep& tallest = sweeps.back();
  const auto right = std::ranges::count_if(
      sweeps, [](const Sweep& s) { return s.candidates[2] <= 1.01 * std::min(s.candidates[0], s.candidates[1]); });
  findings.values.insert({{"aspect", number_text(tallest.aspect)},
                          {"times", three_digits(tallest.candidates[0] / tallest.candidates[1])},
                          {"right", std::to_string(right)},
                          {"shapes", std::to_string(sweeps.size())}});
  return findings;
}

}  // namespace

double expected_interval_overlaps(int64_t count, double length) {
  const auto n = static_cast<double>(count);
  const double share = length < 1 ? 1 : 2 / length - 1 / (length * length);
  return n * (n - 1) / 2 * share;
}

Experiment axis_experiment() { return {"axis", 15, 400, measurements, measure}; }

}  // namespace ballpit
