// SPDX-License-Identifier: MIT
// Which response is fastest: the time of a dense gas against its number of spheres. Each response takes the largest
// step with which its error in the pressure stays within the same tolerance.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/numbers.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/same_error.h"
#include "lab/experiments/timed_run.h"
#include "lab/measure/points.h"
#include "scene/input_error.h"

namespace ballpit {

namespace {

constexpr int kRepeats = 5;

/// A response with its largest step.
struct Entry {
  const Contender* who;
  std::vector<PressureError> errors;  ///< empty for exact motion
  double dt;                          ///< 0 if it holds the tolerance at no step
  std::vector<Point> points{};        ///< seconds for a unit of time, against spheres
};

std::vector<Entry> measure_entries(Lab& lab) {
  std::vector<Entry> entries;
  for (const Contender& who : contenders()) {
    Entry entry{&who, {}, kCoarsestStep};
    if (!is_exact(who)) {
      entry.errors = pressure_errors(lab, who);
      entry.dt = largest_step(entry.errors);
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// Cells along each edge of the lattice that a gas starts from, with 4 spheres each.
std::vector<int> sizes(bool is_quick) {
  return is_quick ? std::vector<int>{2, 4, 6, 9, 14} : std::vector<int>{2, 3, 4, 6, 9, 14, 20, 30, 46};
}

/// [s] for a unit of time, repeat by repeat, the entries in turns. A repeat takes at least `least` seconds.
std::vector<double> time_in_turns(const std::vector<const Entry*>& entries, const Scene& gas, double least) {
  std::vector<TimedRun> runs;
  std::vector<double> parts;  // simulated time of a repeat
  for (const Entry* entry : entries) {
    runs.emplace_back(with_springs(gas, entry->dt), entry->who->settings(entry->dt));
    runs.back().reach(4 * entry->dt);  // warms up
    const double step = runs.back().seconds() * entry->dt;
    parts.push_back(std::max(4 * entry->dt, std::min(1.0, std::ceil(least / step) * entry->dt)));
  }
  std::vector<double> seconds;
  for (int repeat = 1; repeat <= kRepeats; ++repeat) {
    for (size_t k = 0; k < runs.size(); ++k) {
      const double before = runs[k].world().time(), spent = runs[k].spent();
      const bool is_there = runs[k].reach(before + parts[k]);
      const double simulated = runs[k].world().time() - before;
      seconds.push_back(is_there ? (runs[k].spent() - spent) / simulated : INFINITY);
    }
  }
  return seconds;
}

void measure_times(Lab& lab, std::vector<Entry>& entries) {
  const double least = lab.is_quick() ? 0.03 : 0.2;
  std::vector<Entry*> running;
  std::string steps;
  for (Entry& entry : entries) {
    if (entry.dt == 0) continue;
    running.push_back(&entry);
    steps += entry.who->label + ' ' + number_text(entry.dt) + "; ";
  }
  for (const int cells : sizes(lab.is_quick())) {
    const std::vector<double> seconds = lab.time(key_of("time", steps, cells, lab.seed(), least), [&] {
      return time_in_turns({running.begin(), running.end()}, equilibrium_gas(cells, kSameErrorDensity, lab.seed()),
                           least);
    });
    for (size_t k = 0; k < running.size(); ++k) {
      std::vector<double> own;
      for (size_t repeat = 0; repeat < kRepeats; ++repeat) own.push_back(seconds[repeat * running.size() + k]);
      running[k]->points.push_back(point_of(4.0 * cells * cells * cells, spread_of(own)));
    }
  }
}

Chart time_chart(const std::vector<Entry>& entries) {
  Chart chart{"time", "Time of a dense gas, 2 % off in its pressure at most", Axis{"spheres", "", Scale::log},
              Axis{"time for a unit of time, √(mD²/kT)", "s", Scale::log}};
  for (const Entry& entry : entries) {
    if (entry.points.empty()) continue;
    chart.series.push_back(
        {entry.who->label, entry.who->role, entry.points, Stroke::line_and_points, entry.who->is_dashed});
  }
  return chart;
}

Chart error_chart(const std::vector<Entry>& entries) {
  Chart chart{"error", "Error in the pressure against the step", Axis{"step", "√(mD²/kT)", Scale::log},
              Axis{"error of Z", "%", Scale::linear, -30, 10}};
  double finest = kCoarsestStep;
  for (const Entry& entry : entries) {
    if (!entry.errors.empty()) finest = std::min(finest, entry.errors.back().dt);
  }
  for (const double edge : {-100 * kPressureTolerance, 100 * kPressureTolerance}) {
    chart.series.push_back({edge > 0 ? "± 2 %" : "", "theory", {{finest, edge}, {kCoarsestStep, edge}}, Stroke::line});
  }
  for (const Entry& entry : entries) {
    Series series{entry.who->label, entry.who->role, {}, Stroke::line_and_points, entry.who->is_dashed};
    for (auto error = entry.errors.rbegin(); error != entry.errors.rend(); ++error) {
      Point point = point_of(error->dt, Mean{100 * error->off.value, 100 * error->off.error});
      if (std::isnan(point.y) || std::fabs(point.y) > 30) point.y = INFINITY;
      series.points.push_back(point);
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

std::string spheres_text(const Point& point) { return grouped(static_cast<int64_t>(point.x)) + " spheres"; }

/// "stops, from 10 976 spheres on"
std::string stops_from(const Entry& entry) {
  const auto stopped =
      std::find_if(entry.points.begin(), entry.points.end(), [](const Point& p) { return std::isinf(p.y); });
  return "stops, from " + spheres_text(*stopped) + " on";
}

std::vector<Table> tables_of(const std::vector<Entry>& entries) {
  Table errors{"errors", {"response", "step", "error of Z [%]", "standard error [%]"}};
  Table times{"times", {"response", "step", "spheres", "time [s]", "lower quartile [s]", "upper quartile [s]"}};
  Table steps{"steps", {"response", "largest step that holds 2 %", "time for the most spheres [s]"}, {}, true};
  for (const Entry& entry : entries) {
    const std::string& who = entry.who->label;
    for (const PressureError& e : entry.errors) errors.add_row(who, e.dt, 100 * e.off.value, 100 * e.off.error);
    for (const Point& p : entry.points) times.add_row(who, entry.dt, p.x, p.y, p.low, p.high);
    const std::string step = is_exact(*entry.who) ? "any: exact" : entry.dt > 0 ? number_text(entry.dt) : "none tried";
    const double most = entry.points.empty() ? kNoNumber : entry.points.back().y;
    steps.add_row(who, step, std::isinf(most) ? Cell(stops_from(entry)) : Cell(most));
  }
  return {std::move(steps), std::move(times), std::move(errors)};
}

/// The fastest at the k-th number of spheres; `before` again, unless another is faster by more than the spread.
const Entry* fastest_at(const std::vector<Entry>& entries, size_t k, const Entry* before) {
  const Entry* best = before != nullptr ? before : &entries.front();
  for (const Entry& entry : entries) {
    if (!entry.points.empty() && entry.points[k].high < best->points[k].low) best = &entry;
  }
  return best;
}

const Entry* next_fastest(const std::vector<Entry>& entries, const Entry* best) {
  const Entry* next = nullptr;
  for (const Entry& entry : entries) {
    if (&entry == best || entry.points.empty()) continue;
    if (next == nullptr || entry.points.back().y < next->points.back().y) next = &entry;
  }
  return next;
}

/// Which response is fastest, and from how many spheres on.
std::string answer_of(const std::vector<Entry>& entries) {
  const std::vector<Point>& spheres = entries.front().points;  // of exact motion, which always takes part
  std::string text = "With at most 2 % of error in the pressure of a dense gas, ";
  const Entry* best = nullptr;
  for (size_t k = 0; k < spheres.size(); ++k) {
    const Entry* now = fastest_at(entries, k, best);
    if (now == best) continue;
    text += best == nullptr ? fmt::format("“{}” is fastest", now->who->label)
                            : fmt::format(", from {} on “{}”", spheres_text(spheres[k]), now->who->label);
    best = now;
  }
  if (const Entry* next = next_fastest(entries, best)) {
    text += fmt::format("; among {}, “{}” takes {} times as long", spheres_text(spheres.back()), next->who->label,
                        three_digits(next->points.back().y / best->points.back().y));
  }
  return text + ".";
}

int64_t measurements(bool is_quick) {
  return static_cast<int64_t>((contenders().size() - 1) * kStepsTried + sizes(is_quick).size());
}

Findings run(Lab& lab) {
  std::vector<Entry> entries = measure_entries(lab);
  measure_times(lab, entries);
  return {tables_of(entries),
          {time_chart(entries), error_chart(entries)},
          answer_of(entries),
          "A gas of equal elastic spheres, N·D³/V = 0.5, in equilibrium in a periodic box; diameter, mass "
          "and kT are 1, and a sphere has 7.7 collisions in a unit of time. First chart: the time for a unit "
          "of simulated time, on one thread in double precision, medians and quartiles of five repeats in "
          "turns. A × marks runs that stop: among many spheres, some pair soon overlaps by more than a "
          "radius, and the guard ends the run. Second chart: the error of the compressibility Z of 256 "
          "spheres against the literature, for each step (bars: one standard error; ×: beyond 30 %, or the "
          "run stopped). Each response takes the largest step whose error, like that of half the step, is "
          "within 2 %. Discrete impulses find each hit up to a step late, so they need short steps; swept "
          "ones find the hit within the step. The springs of the penalty response last 20 steps, so long "
          "steps mean soft spheres. Exact motion needs no steps, but processes one collision after the "
          "other. Position-based spheres are missing, since they cannot form an elastic gas."};
}

}  // namespace

Experiment crossover_experiment() {
  return {"crossover",
          "Which response when",
          "At the same error, which response is fastest, and does that change with the number of spheres?",
          30,
          200,
          measurements,
          run};
}

}  // namespace ballpit
