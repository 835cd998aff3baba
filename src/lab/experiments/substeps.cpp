// SPDX-License-Identifier: MIT
// The same work spent in two ways: one step with n iterations, or n substeps with one iteration each. Macklin et al.,
// "Small Steps in Physics Simulation" (2019), doi 10.1145/3309486.3340247: substeps leave less error.
//
//     iterations    ├────────────── dt ──────────────┤  contacts once, solved n times
//     substeps      ├── h ──┼── h ──┼── h ──┼── h ──┤  h = dt/n: contacts n times, solved once each
//
// With one iteration in each substep, a contact that carries `load` times the weight of a sphere must lift it by
// load·g·h², as much as it falls. By positions, contacts are solved in two colours, so a contact between two spheres is
// pressed by both neighbours afterwards. In a stack of n the third contact from the floor then overlaps most, by the
// loads of its neighbours: ((n − 2) + (n − 4))·g·h². (From the floor upwards in turn it would be (n − 1)·g·h².) Under a
// sphere R times as heavy as its carrier it is R·g·h².
#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"

namespace ballpit {

namespace {

constexpr double kFrame = 1.0 / 60;  // [s] the step that the work is spent on
constexpr double kRadius = 0.1;      // [m]
constexpr double kRest = 3;          // [s]
constexpr double kGravity = 9.81;    // [m/s²], that of make_stack()
constexpr int kTall = 20, kHeavy = 100;
constexpr int kStacks = 64, kTimedFrames = 20, kRepeats = 3;  // of the timing

/// A way to spend the work, and its line in a chart: iterations are dashed.
struct Way {
  std::string response;
  bool is_substeps;

  std::string name() const { return response + (is_substeps ? ", substeps" : ", iterations"); }
  Series series() const {
    const std::string kind = response == "impulse" ? "impulses" : "positions";
    const std::string label = translated(kind + (is_substeps ? ", substeps" : ", iterations"));
    return {label, response, {}, Stroke::line_and_points, !is_substeps};
  }
};

const std::vector<Way>& ways() {
  static const std::vector<Way> all{
      {"position-based", true}, {"position-based", false}, {"impulse", true}, {"impulse", false}};
  return all;
}

/// Of each way; all of it is in powers of two.
std::vector<double> works(bool is_quick) {
  std::vector<double> all;
  for (double n = 1; n <= (is_quick ? 32 : 256); n *= 2) all.push_back(n);
  return all;
}

struct Load {
  std::string name, title;
  std::vector<double> masses;
  double sinking;       ///< [g·h²] the largest overlap by theory
  std::string formula;  ///< for it
};

const std::vector<Load>& loads() {
  static const std::vector<Load> all{
      {"stack", "Twenty spheres at rest, one upon the other", std::vector<double>(kTall, 1.0), 2 * (kTall - 3),
       "2(n − 3)·g·h²"},
      {"mass-ratio", "A sphere a hundred times as heavy upon a light one", {1.0, kHeavy}, kHeavy, "R·g·h²"}};
  return all;
}

int64_t measurements(bool is_quick) {
  return static_cast<int64_t>(ways().size() * works(is_quick).size() * (loads().size() + 1));
}

/// Tall stacks side by side, which do not touch each other.
Scene many_stacks() {
  const Scene one = make_stack(std::vector<double>(kTall, 1.0), kRadius);
  Scene scene = one;
  scene.bodies = {};
  const int side = static_cast<int>(std::sqrt(kStacks));
  scene.domain.max = {3 * kRadius * side, one.domain.max.y, 3 * kRadius * side};
  scene.domain.min = Vec3d(0.0);
  for (int k = 0; k < side * side; ++k) {
    const Vec3d corner(3 * kRadius * (k % side + 0.5), 0, 3 * kRadius * (k / side + 0.5));
    for (const Vec3d& p : one.bodies.position) put_sphere(scene, corner + p, Vec3d(0.0), kRadius, 1);
  }
  return scene;
}

/// [s] for a frame.
std::vector<double> frame_times(const Way& way, int work) {
  std::vector<double> seconds;
  for (int k = 0; k < kRepeats; ++k) {
    TimedRun run(many_stacks(), equal_work(way.response, kFrame, work, way.is_substeps));
    run.reach(kTimedFrames * kFrame);
    seconds.push_back(run.spent() / kTimedFrames);
  }
  return seconds;
}

/// What one way makes of one load, for each amount of work.
struct Result {
  Way way;
  std::vector<double> overlap;  ///< of a radius; infinite if the run stops
  std::vector<Spread> time;     ///< [s] a frame of kStacks tall stacks
};

std::vector<Result> measure_all(Lab& lab, const Load& load) {
  std::vector<Result> results;
  for (const Way& way : ways()) {
    Result result{way, {}, {}};
    for (const double n : works(lab.is_quick())) {
      const int work = static_cast<int>(n);
      result.overlap.push_back(lab.measure_number(key_of("overlap", load.name, way.name(), n, kRest), [&] {
        return overlap_at_rest(load.masses, equal_work(way.response, kFrame, work, way.is_substeps));
      }));
      if (load.name != loads().front().name) continue;
      result.time.push_back(spread_of(
          lab.time(key_of("time", way.name(), n, kTimedFrames, kStacks), [&] { return frame_times(way, work); })));
    }
    results.push_back(std::move(result));
  }
  return results;
}

Chart work_chart(const std::vector<Result>& results, const Load& load, const std::vector<double>& at) {
  Chart chart{load.name, load.title, Axis{"iterations × substeps in 1/60 s", "", Scale::log},
              Axis{"largest overlap / radius", "", Scale::log, 1e-5, 10}};
  chart.series.push_back(theory_line(
      load.formula, at, [&](double n) { return load.sinking * kGravity * kFrame * kFrame / (n * n) / kRadius; }));
  for (const Result& result : results) {
    Series series = result.way.series();
    for (size_t k = 0; k < at.size(); ++k) series.points.push_back({at[k], result.overlap[k]});
    chart.series.push_back(series);
  }
  return chart;
}

Chart time_chart(const std::vector<Result>& results) {
  Chart chart{"time", phrase("Against the time that it costs: {} stacks", kStacks),
              Axis{"time a frame", "ms", Scale::log}, Axis{"largest overlap / radius", "", Scale::log, 1e-5, 10}};
  for (const Result& result : results) {
    Series series = result.way.series();
    for (size_t k = 0; k < result.time.size(); ++k) {
      series.points.push_back({1e3 * result.time[k].median, result.overlap[k]});
    }
    chart.series.push_back(series);
  }
  return chart;
}

Table table_of(const std::vector<Result>& results, const Load& load, const std::vector<double>& at) {
  Table table{load.name, {"way", "work", "largest overlap / radius", "time a frame [ms]"}};
  for (const Result& result : results) {
    for (size_t k = 0; k < at.size(); ++k) {
      table.add_row(result.way.name(), at[k], result.overlap[k],
                    result.time.empty() ? kNoNumber : 1e3 * result.time[k].median);
    }
  }
  return table;
}

Findings measure(Lab& lab) {
  const std::vector<double> at = works(lab.is_quick());
  Findings findings;
  std::vector<Result> tall;
  for (const Load& load : loads()) {
    const std::vector<Result> results = measure_all(lab, load);
    findings.tables.push_back(table_of(results, load, at));
    findings.charts.push_back(work_chart(results, load, at));
    if (tall.empty()) tall = results;
  }
  findings.charts.insert(findings.charts.begin() + 1, time_chart(tall));
  const auto overlap = [&](size_t way) { return three_digits(tall[way].overlap.back()); };
  const auto cost = [&](size_t way) { return tall[way].time.back().median; };
  // What substeps leave in the time of all iterations: on a straight line in the logarithms.
  size_t k = 1;
  while (k + 1 < at.size() && tall[0].time[k].median < cost(1)) ++k;
  const double part =
      std::log(cost(1) / tall[0].time[k - 1].median) / std::log(tall[0].time[k].median / tall[0].time[k - 1].median);
  const double in_time = tall[0].overlap[k - 1] * std::pow(tall[0].overlap[k] / tall[0].overlap[k - 1], part);
  findings.values = {{"work", number_text(at.back())},
                     {"substeps", overlap(0)},
                     {"iterations", overlap(1)},
                     {"in_time", three_digits(in_time)},
                     {"impulse_substeps", overlap(2)},
                     {"impulse_iterations", overlap(3)},
                     {"costs", three_digits(cost(0) / cost(1))},
                     {"impulse_costs", three_digits(cost(2) / cost(3))},
                     {"stacks", std::to_string(kStacks)}};
  return findings;
}

}  // namespace

Settings equal_work(const std::string& response, double dt, int work, bool is_substeps) {
  Settings settings = settings_of(response, dt);
  settings.solver = Solver::gauss_seidel;
  settings.substeps = is_substeps ? work : 1;
  settings.iterations = is_substeps ? 1 : work;
  settings.max_overlap = 1e6;  // failures are to be seen
  settings.max_energy = 1e15;
  return settings;
}

double overlap_at_rest(const std::vector<double>& masses, const Settings& settings) {
  TimedRun run(make_stack(masses, kRadius), settings);
  return run.reach(kRest) ? run.world().report().max_overlap : INFINITY;
}

Experiment substeps_experiment() { return {"substeps", 4, 25, measurements, measure}; }

}  // namespace ballpit
