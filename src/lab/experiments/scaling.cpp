// SPDX-License-Identifier: MIT
// The diagram of exercise sheet 3: the time of a step against the number of spheres, for each broad phase, backend and
// number of threads, with exponents of growth fitted to the upper part.
#include <cmath>

#include "lab/experiments/experiments.h"
#include "lab/measure/searches.h"
#include "measure/machine.h"
#include "measure/step_timing.h"

namespace ballpit {

namespace {

constexpr int kBlocks = 5;
constexpr double kFittedFrom = 0.03;  // of the largest number of spheres: fits use the part from there on

std::vector<int64_t> counts(bool is_quick) {
  if (is_quick) return {100, 300, 1000, 3000, 10'000, 30'000};
  return {100, 300, 1000, 3000, 10'000, 30'000, 100'000, 300'000, 1'000'000};
}

std::vector<StepCase> cases() {
  std::vector<std::pair<Backend, int>> where{{cpu_backend(), 1}};
  if (thread_count(0) > 1) where.emplace_back(cpu_backend(), thread_count(0));
  if (cuda_backend().unavailable_reason.empty()) where.emplace_back(cuda_backend(), 0);
  std::vector<StepCase> result;
  for (const auto& [backend, threads] : where) {
    for (const std::string& method : broad_phases()) result.push_back({method, backend, threads});
  }
  return result;
}

std::string threads_text(int threads) { return threads == 1 ? translated("1 thread") : phrase("{} threads", threads); }

/// One case for all counts.
struct Curve {
  StepCase which;
  std::vector<Point> points = {};      ///< [ms] of a step: median and quartiles
  std::vector<Point> candidates = {};  ///< at the same counts
};

/// For each case the mean time of a step in each block [s], then the candidates; NaN if it was skipped.
std::vector<double> measure_count(int64_t count, uint64_t seed, bool is_quick) {
  TimingPlan plan;
  plan.cases = cases();
  plan.counts = {count};
  plan.blocks = kBlocks;
  plan.seed = seed;
  plan.limit = is_quick ? 2 : 20;
  std::vector<double> flat;
  for (const StepTiming& timing : time_steps(
           plan, [](int64_t) {}, [] { return false; })) {
    const bool is_whole = timing.seconds.size() == kBlocks;
    for (size_t k = 0; k < kBlocks; ++k) flat.push_back(is_whole ? timing.seconds[k] : kNoNumber);
    flat.push_back(is_whole ? static_cast<double>(timing.candidates) : kNoNumber);
  }
  return flat;
}

/// The fit of the upper part of a curve.
PowerFit fit_upper(const std::vector<Point>& points) {
  std::vector<double> x, y;
  for (const Point& point : points) {
    if (point.x < kFittedFrom * points.back().x || point.y <= 0) continue;
    x.push_back(point.x);
    y.push_back(point.y);
  }
  return x.size() < 2 ? PowerFit{kNoNumber, kNoNumber, kNoNumber} : fit_power(x, y);
}

std::vector<Curve> measure_all(Lab& lab) {
  std::vector<Curve> curves;
  for (const StepCase& which : cases()) curves.push_back({which});
  for (const int64_t count : counts(lab.is_quick())) {
    const std::string key =
        fmt::format("ms a step; gas of {}; seed {}; {}", count, lab.seed(), lab.is_quick() ? "quick" : "full");
    const std::vector<double> flat = lab.time(key, [&] { return measure_count(count, lab.seed(), lab.is_quick()); });
    for (size_t k = 0; k < curves.size(); ++k) {
      const auto first = flat.begin() + static_cast<std::ptrdiff_t>(k) * (kBlocks + 1);
      if (std::isnan(*first)) continue;
      const auto spheres = static_cast<double>(count);
      curves[k].points.push_back(point_of(spheres, spread_of({first, first + kBlocks}), 1e3));
      curves[k].candidates.push_back({spheres, first[kBlocks]});
    }
  }
  return curves;
}

/// The line n^p·log(n)^q that ends at this point.
Series guide(const std::string& label, double power, double log_power, const Point& end, double from) {
  return theory_line(label, spaced(from, end.x, 21, Scale::log), [&](double n) {
    return end.y * std::pow(n / end.x, power) * std::pow(std::log(n) / std::log(end.x), log_power);
  });
}

/// Lines that show how n², n·log n and n grow: the first above brute force, the others below the fastest curve.
std::vector<Series> guides(const std::vector<Curve>& curves) {
  Point end{0, INFINITY};  // of the fastest with the most spheres
  for (const Curve& curve : curves) {
    if (curve.points.empty()) continue;
    const Point& last = curve.points.back();
    if (last.x > end.x || (last.x == end.x && last.y < end.y)) end = last;
  }
  std::vector<Series> result{guide("O(n)", 1, 0, {end.x, end.y / 4}, end.x / 100),
                             guide("O(n log n)", 1, 1, {end.x, end.y / 2}, end.x / 100)};
  const std::vector<Point>& slowest = curves.front().points;
  if (slowest.size() > 2) {
    result.push_back(guide("O(n²)", 2, 0, {slowest.back().x, 3 * slowest.back().y}, slowest.back().x / 20));
  }
  return result;
}

/// One chart for each backend and number of threads, with all broad phases.
std::vector<Chart> charts_of(const std::vector<Curve>& curves) {
  std::vector<Chart> charts;
  const auto methods = static_cast<std::ptrdiff_t>(broad_phases().size());
  for (auto first = curves.begin(); first != curves.end(); first += methods) {
    const std::vector<Curve> chosen(first, first + methods);
    const auto& [method, backend, threads] = first->which;
    const std::string name = threads == 0 ? backend.name : std::to_string(threads);
    const std::string where = threads == 0 ? "CUDA" : threads == 1 ? translated("one thread") : threads_text(threads);
    Chart chart{"time-" + name, phrase("Time a step against spheres, {}", where), Axis{"spheres", "", Scale::log},
                Axis{"time a step", "ms", Scale::log}, guides(chosen)};
    for (const Curve& curve : chosen) {
      chart.series.push_back({label_of(curve.which.method), curve.which.method, curve.points, Stroke::line_and_points,
                              backend.name != "cpu"});
    }
    charts.push_back(std::move(chart));
  }
  return charts;
}

Table times_of(const std::vector<Curve>& curves) {
  Table table{"times",
              {"broad phase", "backend", "threads", "spheres", "time a step [ms]", "lower quartile [ms]",
               "upper quartile [ms]", "candidates"}};
  for (const Curve& curve : curves) {
    const StepCase& which = curve.which;
    for (size_t k = 0; k < curve.points.size(); ++k) {
      const Point& p = curve.points[k];
      table.add_row(which.method, which.backend.name, which.threads, p.x, p.y, p.low, p.high, curve.candidates[k].y);
    }
  }
  return table;
}

Table exponents_of(const std::vector<Curve>& curves) {
  Table table{"exponents",
              {"broad phase", "exponent of time", "standard error", "exponent of candidates", "most spheres",
               "time a step [ms]"},
              {},
              true};
  for (const Curve& curve : curves) {
    if (curve.points.empty()) continue;
    const StepCase& which = curve.which;
    const std::string where = which.threads == 0 ? which.backend.name : threads_text(which.threads);
    const PowerFit fit = fit_upper(curve.points);
    table.add_row(which.method + ", " + where, fit.exponent, fit.error, fit_upper(curve.candidates).exponent,
                  curve.points.back().x, curve.points.back().y);
  }
  return table;
}

int64_t measurements(bool is_quick) { return static_cast<int64_t>(counts(is_quick).size()); }

Findings measure(Lab& lab) {
  const std::vector<Curve> curves = measure_all(lab);
  Findings findings{{times_of(curves), exponents_of(curves)}, charts_of(curves), {}};
  const auto points_of = [&](const char* method) {
    return std::ranges::find(curves, method, [](const Curve& curve) { return curve.which.method; })->points;
  };
  const std::vector<Point> brute = points_of("brute-force"), sweep = points_of("sort-and-sweep"),
                           grid = points_of("sorted-grid");
  const auto same = brute.empty() ? grid.end() : std::ranges::find(grid, brute.back().x, &Point::x);
  if (same == grid.end()) {
    findings.answer = translated("Too little could be measured for an answer.");
    return findings;
  }
  findings.values = {{"brute_force", three_digits(fit_upper(brute).exponent)},
                     {"sort_and_sweep", three_digits(fit_upper(sweep).exponent)},
                     {"sorted_grid", three_digits(fit_upper(grid).exponent)},
                     {"spheres", grouped(static_cast<int64_t>(same->x))},
                     {"speedup", three_digits(brute.back().y / same->y)}};
  return findings;
}

}  // namespace

Experiment scaling_experiment() { return {"scaling", 15, 150, measurements, measure}; }

}  // namespace ballpit
