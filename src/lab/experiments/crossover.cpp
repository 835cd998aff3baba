// SPDX-License-Identifier: MIT
// Which response is fastest: the time of a dense gas against its number of spheres. Each response takes the largest
// step with which its error in the pressure stays within the same tolerance.

#include "core/error.h"
#include "lab/experiments/contact_methods.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"
#include "measure/theory.h"

namespace ballpit {

namespace {

constexpr double kDensity = 0.5;         // N·D³/V
constexpr double kTolerance = 0.02;      // of Z
constexpr double kCoarsestStep = 0.256;  // steps are this·2^−k
constexpr int kStepsTried = 12;          // at most, for each response
constexpr int kRepeats = 5;

/// A response with its settings, on one thread in double precision, and what is measured of it.
struct Entry {
  std::string label, role;
  bool is_dashed;
  Settings (*settings)(double dt);
  std::vector<PressureError> errors = {};  ///< empty for exact motion
  double dt = kCoarsestStep;               ///< its largest step; 0 if it holds the tolerance at no step
  std::vector<Point> points = {};          ///< seconds for a unit of time, against spheres

  bool is_exact() const { return role == "event-driven"; }
};

Settings stepping(Settings settings) {
  settings.broadphase = BroadPhase::automatic;  // with a candidate list, which suits short steps
  return settings;
}

/// Exact motion first.
std::vector<Entry> contenders() {
  return {
      {"event-driven", "event-driven", false, exact_motion},
      {"impulse", "impulse", false, [](double dt) { return stepping(elastic_impulses(dt, false)); }},
      {"impulse, swept", "impulse", true, [](double dt) { return stepping(elastic_impulses(dt, true)); }},
      {"penalty", "penalty", false, [](double dt) { return stepping(settings_of("penalty", dt)); }},
      {"kinematic", "kinematic", false, [](double dt) { return stepping(settings_of("kinematic", dt)); }},
  };
}

PressureError error_at(Lab& lab, const Entry& entry, double dt) {
  const GasRun run{4, kDensity, lab.seed(), lab.is_quick() ? 20 : 60, 15};
  const std::vector<double> z = lab.measure(key_of("Z", entry.label, dt, run.seed, run.blocks), [&] {
    try {
      return block_z(run, entry.settings(dt), with_springs(equilibrium_gas(run.cells, kDensity, run.seed), dt));
    } catch (const RunError&) {
      return std::vector<double>{kNoNumber, kNoNumber};
    }
  });
  const double expected = finite_z(kDensity, count_of(run));
  const Mean mean = mean_of(z);
  return {dt, {mean.value / expected - 1, mean.error / expected}};
}

/// Measures the error at each step, coarsest first, until two in a row are within the tolerance.
std::vector<Entry> measure_errors(Lab& lab) {
  std::vector<Entry> entries = contenders();
  for (Entry& entry : entries) {
    if (entry.is_exact()) continue;
    entry.dt = 0;
    for (int k = 0; k < kStepsTried && entry.dt == 0; ++k) {
      entry.errors.push_back(error_at(lab, entry, kCoarsestStep * std::exp2(-k)));
      entry.dt = largest_step(entry.errors);
    }
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
    runs.emplace_back(with_springs(gas, entry->dt), entry->settings(entry->dt));
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
    steps += entry.label + ' ' + number_text(entry.dt) + "; ";
  }
  for (const int cells : sizes(lab.is_quick())) {
    const std::vector<double> seconds = lab.time(key_of("time", steps, cells, lab.seed(), least), [&] {
      return time_in_turns({running.begin(), running.end()}, equilibrium_gas(cells, kDensity, lab.seed()), least);
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
    chart.series.push_back({entry.label, entry.role, entry.points, Stroke::line_and_points, entry.is_dashed});
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
  for (const double edge : {-100 * kTolerance, 100 * kTolerance}) {
    chart.series.push_back({edge > 0 ? "± 2 %" : "", "theory", {{finest, edge}, {kCoarsestStep, edge}}, Stroke::line});
  }
  for (const Entry& entry : entries) {
    Series series{entry.label, entry.role, {}, Stroke::line_and_points, entry.is_dashed};
    for (auto error = entry.errors.rbegin(); error != entry.errors.rend(); ++error) {
      Point point = point_of(error->dt, Mean{100 * error->off.value, 100 * error->off.error});
      if (std::isnan(point.y) || std::fabs(point.y) > 30) point.y = INFINITY;
      series.points.push_back(point);
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

std::string spheres_text(const Point& point) { return grouped(static_cast<int64_t>(point.x)); }

/// "stops, from 10 976 spheres on"
std::string stops_from(const Entry& entry) {
  const auto stopped = std::ranges::find(entry.points, INFINITY, &Point::y);
  return phrase("stops, from {} spheres on", spheres_text(*stopped));
}

std::vector<Table> tables_of(const std::vector<Entry>& entries) {
  Table errors{"errors", {"response", "step", "error of Z [%]", "standard error [%]"}};
  Table times{"times", {"response", "step", "spheres", "time [s]", "lower quartile [s]", "upper quartile [s]"}};
  Table steps{"steps", {"response", "largest step that holds 2 %", "time for the most spheres [s]"}, {}, true};
  for (const Entry& entry : entries) {
    const std::string& who = entry.label;
    for (const PressureError& e : entry.errors) errors.add_row(who, e.dt, 100 * e.off.value, 100 * e.off.error);
    for (const Point& p : entry.points) times.add_row(who, entry.dt, p.x, p.y, p.low, p.high);
    const std::string step = entry.is_exact() ? "any: exact" : entry.dt > 0 ? number_text(entry.dt) : "none tried";
    const double most = entry.points.empty() ? kNoNumber : entry.points.back().y;
    steps.add_row(who, step, std::isinf(most) ? Cell(stops_from(entry)) : Cell(most));
  }
  return {std::move(steps), std::move(times), std::move(errors)};
}

/// Which response is fastest, and from how many spheres on. It changes only where another is faster by more than the
/// spread.
std::string fastest_of(const std::vector<Entry>& entries) {
  const std::vector<Point>& spheres = entries.front().points;  // of exact motion, which always takes part
  std::string text;
  const Entry* best = &entries.front();
  for (size_t k = 0; k < spheres.size(); ++k) {
    const Entry* before = best;
    for (const Entry& entry : entries) {
      if (!entry.points.empty() && entry.points[k].high < best->points[k].low) best = &entry;
    }
    if (k == 0) {
      text = phrase("“{}” is fastest", best->label);
    } else if (best != before) {
      text += phrase(", from {} spheres on “{}”", spheres_text(spheres[k]), best->label);
    }
  }
  const Entry* next = nullptr;
  for (const Entry& entry : entries) {
    if (&entry == best || entry.points.empty()) continue;
    if (next == nullptr || entry.points.back().y < next->points.back().y) next = &entry;
  }
  if (next == nullptr) return text;
  return text + phrase("; among {} spheres, “{}” takes {} times as long", spheres_text(spheres.back()), next->label,
                       three_digits(next->points.back().y / best->points.back().y));
}

int64_t measurements(bool is_quick) {
  return static_cast<int64_t>((contenders().size() - 1) * kStepsTried + sizes(is_quick).size());
}

Findings measure(Lab& lab) {
  std::vector<Entry> entries = measure_errors(lab);
  measure_times(lab, entries);
  return {tables_of(entries), {time_chart(entries), error_chart(entries)}, {{"fastest", fastest_of(entries)}}};
}

}  // namespace

double largest_step(const std::vector<PressureError>& errors) {
  const auto holds = [](const PressureError& error) { return std::fabs(error.off.value) <= kTolerance; };
  const bool is_found = errors.size() > 1 && holds(errors.back()) && holds(errors[errors.size() - 2]);
  return is_found ? errors[errors.size() - 2].dt : 0;
}

Experiment crossover_experiment() { return {"crossover", 30, 200, measurements, measure}; }

}  // namespace ballpit
