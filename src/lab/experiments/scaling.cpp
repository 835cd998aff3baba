// SPDX-License-Identifier: MIT
// Exercise sheet 3's diagram: time a step against the number of spheres, for each broad phase, backend and number of
// threads, with the exponents of growth fitted to the upper part.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "core/numbers.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/fit.h"
#include "lab/measure/search_timing.h"
#include "measure/gas.h"
#include "measure/machine.h"
#include "measure/spread.h"
#include "measure/step_timing.h"

namespace ballpit {

namespace {

constexpr int kBlocks = 5;
constexpr double kFittedFrom = 0.03;  // of the largest number of spheres: the upper part, which the exponent is of

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

std::string name_of(const StepCase& which) {
  const std::string threads = which.threads == 0   ? which.backend.name
                              : which.threads == 1 ? "1 thread"
                                                   : std::to_string(which.threads) + " threads";
  return which.method + ", " + threads;
}

/// One case through all counts.
struct Curve {
  StepCase which;
  std::vector<Point> points;  ///< milliseconds a step: median and quartiles
  std::vector<double> candidates;
  PowerFit fit, candidates_fit;  ///< of milliseconds, of candidates
};

/// Of each case: its blocks [s a step], then its candidates; not a number where it was skipped.
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

/// Of the upper part: `values` belong to the curve's points.
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
    const std::string key = "ms a step; gas of " + std::to_string(count) + "; seed " + std::to_string(lab.seed()) +
                            (lab.is_quick() ? "; quick" : "; full");
    const std::vector<double> flat = lab.time(key, [&] { return measure_count(count, lab.seed(), lab.is_quick()); });
    for (size_t k = 0; k < curves.size(); ++k) {
      const auto first = flat.begin() + static_cast<std::ptrdiff_t>(k) * (kBlocks + 1);
      if (std::isnan(*first)) continue;
      const Spread spread = spread_of({first, first + kBlocks});
      curves[k].points.push_back(
          {static_cast<double>(count), 1e3 * spread.median, 1e3 * spread.lower, 1e3 * spread.upper});
      curves[k].candidates.push_back(first[kBlocks]);
    }
  }
  for (Curve& curve : curves) fit(curve);
  return curves;
}

/// A guide of slope n^p·log(n)^q that ends at this point.
Series guide(const std::string& label, double power, double log_power, const Point& end, double from) {
  Series series{label, "theory", {}, Stroke::line};
  for (int k = 0; k <= 20; ++k) {
    const double n = from * std::pow(end.x / from, k / 20.0);
    series.points.push_back(
        {n, end.y * std::pow(n / end.x, power) * std::pow(std::log(n) / std::log(end.x), log_power)});
  }
  return series;
}

/// Beside the curves: the square above brute force, the others below the fastest.
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

Chart chart_of(const std::string& name, const std::string& title, const std::vector<const Curve*>& curves) {
  Chart chart{name, title, {"spheres", "", Scale::log}, {"time a step", "ms", Scale::log}, guides(curves)};
  for (const Curve* curve : curves) {
    Series series{label_of(curve->which.method), curve->which.method, curve->points};
    series.is_dashed = curve->which.backend.name != "cpu";
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::vector<Chart> charts_of(const std::vector<Curve>& curves) {
  std::vector<Chart> charts;
  for (size_t first = 0; first < curves.size(); first += broad_phases().size()) {
    std::vector<const Curve*> chosen;
    for (size_t k = 0; k < broad_phases().size(); ++k) chosen.push_back(&curves[first + k]);
    const StepCase& which = curves[first].which;
    const std::string where = which.threads == 1   ? "one thread"
                              : which.threads == 0 ? "CUDA"
                                                   : std::to_string(which.threads) + " threads";
    charts.push_back(chart_of("time-" + (which.threads == 0 ? which.backend.name : std::to_string(which.threads)),
                              "Time a step against spheres, " + where, chosen));
  }
  return charts;
}

Table times_of(const std::vector<Curve>& curves) {
  Table table{"times",
              {{"broad phase"},
               {"backend"},
               {"threads"},
               {"spheres"},
               {"time a step", "ms"},
               {"lower quartile", "ms"},
               {"upper quartile", "ms"},
               {"candidates"}},
              {}};
  for (const Curve& curve : curves) {
    const StepCase& which = curve.which;
    for (size_t k = 0; k < curve.points.size(); ++k) {
      const Point& p = curve.points[k];
      table.rows.push_back({which.method, which.backend.name, static_cast<double>(which.threads), p.x, p.y, p.low,
                            p.high, curve.candidates[k]});
    }
  }
  return table;
}

Table exponents_of(const std::vector<Curve>& curves) {
  Table table{"exponents",
              {{"broad phase"},
               {"exponent of time"},
               {"standard error"},
               {"exponent of candidates"},
               {"most spheres"},
               {"time a step", "ms"}},
              {},
              true};
  for (const Curve& curve : curves) {
    if (curve.points.empty()) continue;
    table.rows.push_back({name_of(curve.which), curve.fit.exponent, curve.fit.error, curve.candidates_fit.exponent,
                          curve.points.back().x, curve.points.back().y});
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
  const auto grid_at = [&](double x) {
    return std::find_if(grid.points.begin(), grid.points.end(), [&](const Point& p) { return p.x == x; });
  };
  if (brute.points.empty() || grid_at(brute.points.back().x) == grid.points.end())
    return "Too little could be measured for an answer.";
  const Point& last = brute.points.back();
  const auto same = grid_at(last.x);
  return "On one thread time grows as n to the power of " + three_digits(brute.fit.exponent) + " by brute force, " +
         three_digits(sweep.fit.exponent) + " by sort and sweep, " + three_digits(grid.fit.exponent) +
         " by the sorted grid, which steps " + grouped(static_cast<int64_t>(last.x)) + " spheres " +
         three_digits(last.y / same->y) + " times as fast as brute force.";
}

int64_t measurements(bool is_quick) { return static_cast<int64_t>(counts(is_quick).size()); }

Findings run(Lab& lab) {
  const std::vector<Curve> curves = measure_all(lab);
  Findings findings;
  findings.tables = {times_of(curves), exponents_of(curves)};
  findings.charts = charts_of(curves);
  findings.answer = answer_of(curves);
  findings.see =
      "Whole steps of a gas of equal elastic spheres that fill 30 % of a box: detection, response, motion. Both axes "
      "are logarithmic, so a power of n is a straight line; dotted, what O(n²), O(n log n) and O(n) look like. "
      "Points are medians of five blocks of steps, bars their quartiles; all methods are measured in turns. "
      "Exponents are least squares in the logarithms, over the upper part of each curve (a thirtieth of its most "
      "spheres, or more): below that, what a step costs however few spheres there are hides the growth. Brute force "
      "ends where a block would take too long. In a cube sort and sweep walks n to the power of 5/3 entries, since "
      "an interval's share of the axis shrinks only as the cube root of n; its time follows that where walking "
      "outweighs sorting: the table gives the exponent of what is counted, the candidates, beside that of what is "
      "timed.";
  return findings;
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
