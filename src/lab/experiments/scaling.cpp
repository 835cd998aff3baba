// SPDX-License-Identifier: MIT
// The diagram of exercise sheet 3: the time of a step against the number of spheres, for each broad phase, backend and
// number of threads, with exponents of growth fitted to the upper part.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/numbers.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/points.h"
#include "lab/measure/search_timing.h"
#include "measure/gas.h"
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
  std::vector<StepCase> result;
  for (const Backend& backend : {cpu_backend(), cuda_backend()}) {
    if (!backend.unavailable_reason.empty()) continue;
    std::vector<int> threads{1, thread_count(0)};
    if (backend.name != "cpu") threads = {0};
    if (threads.size() == 2 && threads[0] == threads[1]) threads.pop_back();
    for (const int t : threads) {
      for (const std::string& method : broad_phases()) result.push_back({method, backend, t});
    }
  }
  return result;
}

std::string threads_text(int threads) { return threads == 1 ? "1 thread" : fmt::format("{} threads", threads); }

/// One case for all counts.
struct Curve {
  StepCase which;
  std::vector<Point> points;  ///< [ms] of a step: median and quartiles
  std::vector<double> candidates;
  PowerFit fit, candidates_fit;  ///< of the points, of the candidates
};

/// For each case the mean time of a step in each block [s], then the candidates; NaN if it was skipped.
std::vector<double> measure_count(int64_t count, uint64_t seed, bool is_quick) {
  TimingPlan plan;
  plan.cases = cases();
  plan.counts = {count};
  plan.blocks = kBlocks;
  plan.seed = seed;
  plan.limit = is_quick ? 2 : 20;
  const auto nobody = [](int64_t) {};
  const auto never = [] { return false; };
  std::vector<double> flat;
  for (const StepTiming& timing : time_steps(plan, nobody, never)) {
    const bool is_whole = timing.seconds.size() == kBlocks;
    for (size_t k = 0; k < kBlocks; ++k) flat.push_back(is_whole ? timing.seconds[k] : kNoNumber);
    flat.push_back(is_whole ? static_cast<double>(timing.candidates) : kNoNumber);
  }
  return flat;
}

/// The fit of the upper part. `values` belong to the points of the curve.
PowerFit fit_upper(const Curve& curve, const std::vector<double>& values) {
  std::vector<double> x, y;
  for (size_t k = 0; k < curve.points.size(); ++k) {
    if (curve.points[k].x < kFittedFrom * curve.points.back().x || values[k] <= 0) continue;
    x.push_back(curve.points[k].x);
    y.push_back(values[k]);
  }
  return x.size() < 2 ? PowerFit{kNoNumber, kNoNumber, kNoNumber} : fit_power(x, y);
}

void fit(Curve& curve) {
  std::vector<double> milliseconds;
  for (const Point& point : curve.points) milliseconds.push_back(point.y);
  curve.fit = fit_upper(curve, milliseconds);
  curve.candidates_fit = fit_upper(curve, curve.candidates);
}

std::vector<Curve> measure_all(Lab& lab) {
  std::vector<Curve> curves;
  for (const StepCase& which : cases()) curves.push_back({which, {}, {}, {}, {}});
  for (const int64_t count : counts(lab.is_quick())) {
    const std::string key =
        fmt::format("ms a step; gas of {}; seed {}; {}", count, lab.seed(), lab.is_quick() ? "quick" : "full");
    const std::vector<double> flat = lab.time(key, [&] { return measure_count(count, lab.seed(), lab.is_quick()); });
    for (size_t k = 0; k < curves.size(); ++k) {
      const auto first = flat.begin() + static_cast<std::ptrdiff_t>(k) * (kBlocks + 1);
      if (std::isnan(*first)) continue;
      curves[k].points.push_back(point_of(static_cast<double>(count), spread_of({first, first + kBlocks}), 1e3));
      curves[k].candidates.push_back(first[kBlocks]);
    }
  }
  for (Curve& curve : curves) fit(curve);
  return curves;
}

/// The line n^p·log(n)^q that ends at this point.
Series guide(const std::string& label, double power, double log_power, const Point& end, double from) {
  std::vector<double> xs;
  for (int k = 0; k <= 20; ++k) xs.push_back(from * std::pow(end.x / from, k / 20.0));
  return theory_line(label, xs, [&](double n) {
    return end.y * std::pow(n / end.x, power) * std::pow(std::log(n) / std::log(end.x), log_power);
  });
}

/// Lines that show how n², n·log n and n grow: the first above brute force, the others below the fastest curve.
std::vector<Series> guides(const std::vector<const Curve*>& curves) {
  double fastest = INFINITY, largest = 0, smallest = INFINITY;
  for (const Curve* curve : curves) {
    if (curve->points.empty()) continue;
    largest = std::max(largest, curve->points.back().x);
    smallest = std::min(smallest, curve->points.front().x);
  }
  for (const Curve* curve : curves) {
    if (!curve->points.empty() && curve->points.back().x == largest) {
      fastest = std::min(fastest, curve->points.back().y);
    }
  }
  std::vector<Series> result{guide("O(n)", 1, 0, {largest, fastest / 4}, largest / 100),
                             guide("O(n log n)", 1, 1, {largest, fastest / 2}, largest / 100)};
  const std::vector<Point>& slowest = curves.front()->points;
  if (slowest.size() > 2) {
    result.push_back(guide("O(n²)", 2, 0, {slowest.back().x, 3 * slowest.back().y}, slowest.back().x / 20));
  }
  return result;
}

/// One chart for each backend and number of threads, with all broad phases.
std::vector<Chart> charts_of(const std::vector<Curve>& curves) {
  std::vector<Chart> charts;
  for (size_t first = 0; first < curves.size(); first += broad_phases().size()) {
    std::vector<const Curve*> chosen;
    for (size_t k = 0; k < broad_phases().size(); ++k) chosen.push_back(&curves[first + k]);
    const StepCase& which = curves[first].which;
    const std::string name = which.threads == 0 ? which.backend.name : std::to_string(which.threads);
    const std::string where = which.threads == 0   ? "CUDA"
                              : which.threads == 1 ? "one thread"
                                                   : threads_text(which.threads);
    Chart chart{"time-" + name, "Time a step against spheres, " + where, Axis{"spheres", "", Scale::log},
                Axis{"time a step", "ms", Scale::log}, guides(chosen)};
    for (const Curve* curve : chosen) {
      chart.series.push_back({label_of(curve->which.method), curve->which.method, curve->points,
                              Stroke::line_and_points, which.backend.name != "cpu"});
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
      table.add_row(which.method, which.backend.name, which.threads, p.x, p.y, p.low, p.high, curve.candidates[k]);
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
    table.add_row(which.method + ", " + where, curve.fit.exponent, curve.fit.error, curve.candidates_fit.exponent,
                  curve.points.back().x, curve.points.back().y);
  }
  return table;
}

const Curve& curve_of(const std::vector<Curve>& curves, const std::string& method) {
  return *std::find_if(curves.begin(), curves.end(), [&](const Curve& c) { return c.which.method == method; });
}

std::string answer_of(const std::vector<Curve>& curves) {
  const Curve& brute = curve_of(curves, "brute-force");
  const Curve& sweep = curve_of(curves, "sort-and-sweep");
  const Curve& grid = curve_of(curves, "sorted-grid");
  const auto same = std::find_if(grid.points.begin(), grid.points.end(),
                                 [&](const Point& p) { return !brute.points.empty() && p.x == brute.points.back().x; });
  if (same == grid.points.end()) return "Too little could be measured for an answer.";
  const Point& last = brute.points.back();
  return fmt::format(
      "On one thread time grows as n to the power of {} by brute force, {} by sort and sweep, {} by the sorted grid, "
      "which "
      "steps {} spheres {} times as fast as brute force.",
      three_digits(brute.fit.exponent), three_digits(sweep.fit.exponent), three_digits(grid.fit.exponent),
      grouped(static_cast<int64_t>(last.x)), three_digits(last.y / same->y));
}

int64_t measurements(bool is_quick) { return static_cast<int64_t>(counts(is_quick).size()); }

Findings run(Lab& lab) {
  const std::vector<Curve> curves = measure_all(lab);
  return {{times_of(curves), exponents_of(curves)},
          charts_of(curves),
          answer_of(curves),
          "Whole steps of a gas of equal elastic spheres that fill 30 % of a box: detection, response, "
          "motion. Both axes are logarithmic, so a power of n is a straight line; dotted lines show O(n²), "
          "O(n log n) and O(n). Points are medians of five blocks of steps, bars their quartiles; all "
          "methods are measured in turns. Exponents are least squares in the logarithms over the upper part "
          "of each curve, from a thirtieth of its largest number of spheres on; below that, the constant "
          "cost of a step hides the growth. Brute force ends where a block would take too long. In a cube, "
          "sort and sweep walks n to the power of 5/3 entries, since an interval's share of the axis shrinks "
          "only as the cube root of n. Its time follows that once walking takes longer than sorting. The "
          "table gives the exponents of both the time and the candidates."};
}

}  // namespace

Experiment scaling_experiment() {
  return {"scaling",
          "Time against the number of spheres",
          "How does the time of a step grow with the number of spheres, for each broad phase?",
          15,
          150,
          measurements,
          run};
}

}  // namespace ballpit
