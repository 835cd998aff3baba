// SPDX-License-Identifier: MIT
// What accuracy costs: time per simulated second against error, of every response, integrator, step and precision.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "lab/experiments/accuracy.h"
#include "lab/experiments/experiments.h"
#include "lab/key.h"
#include "lab/mean.h"
#include "lab/spread.h"
#include "simulate/response/damping.h"

namespace ballpit {

namespace {

constexpr double kTolerances[] = {0.1, 0.01, 0.001};
constexpr double kLeastError = 1e-10;  // what is less is drawn there, and in no front before another

int repeats(bool is_quick) { return is_quick ? 3 : 5; }

bool has_steps(const ContactMethod& method) { return method.settings.response != "event-driven"; }

/// The steps at which a method does a task: the coarsest alone where it has none.
std::vector<double> steps_of(const Task& task, const ContactMethod& method, bool is_quick) {
  const int halvings = has_steps(method) ? (is_quick ? task.quick_halvings : task.full_halvings) : 0;
  std::vector<double> steps;
  for (int k = 0; k <= halvings; ++k) steps.push_back(std::ldexp(task.coarsest, -k));
  return steps;
}

/// A method at one step.
struct Result {
  const ContactMethod* method;
  double dt;
  double error;  ///< infinite where it failed
  double floor;  ///< standard error, where errors are of random runs
  Spread seconds;
  bool has_failed() const { return !std::isfinite(error); }
};

/// All trials of a task: of each repeat all methods at all steps, so that what else the machine does falls on all alike.
std::vector<std::vector<Trial>> trials_of(Lab& lab, const Task& task) {
  std::vector<std::vector<Trial>> trials;  // of each method and step, in turns
  for (int repeat = 0; repeat < repeats(lab.is_quick()); ++repeat) {
    size_t which = 0;
    for (const ContactMethod& method : contact_methods()) {
      if (!task.serves(method)) continue;
      for (const double dt : steps_of(task, method, lab.is_quick())) {
        const uint64_t seed = lab.seed() * 100 + static_cast<uint64_t>(repeat);
        const auto key = key_of({task.name, method.name, dt, double(seed), lab.is_quick() ? "quick" : "full"});
        const auto values = lab.time(key, [&] {
          const Trial trial = task.run(method, dt, seed, lab.is_quick());
          return std::vector<double>{trial.off, trial.seconds};
        });
        if (repeat == 0) trials.emplace_back();
        trials[which++].push_back({values[0], values[1]});
      }
    }
  }
  return trials;
}

Result result_of(const ContactMethod& method, double dt, const std::vector<Trial>& trials) {
  std::vector<double> off, seconds;
  for (const Trial& trial : trials) {
    off.push_back(trial.off);
    seconds.push_back(trial.seconds);
  }
  const Mean mean = mean_of(off);
  const double error = std::isfinite(mean.value) ? std::fabs(mean.value) : std::numeric_limits<double>::infinity();
  return {&method, dt, error, mean.error, spread_of(seconds)};
}

std::vector<Result> results_of(Lab& lab, const Task& task) {
  const auto trials = trials_of(lab, task);
  std::vector<Result> results;
  for (const ContactMethod& method : contact_methods()) {
    if (!task.serves(method)) continue;
    for (const double dt : steps_of(task, method, lab.is_quick())) {
      results.push_back(result_of(method, dt, trials[results.size()]));
    }
  }
  return results;
}

/// Those that nobody beats in both error and time, fastest first. Errors below `floor` are as good as it.
std::vector<Result> front_of(std::vector<Result> results, double floor) {
  for (Result& result : results) result.error = std::max({result.error, floor, kLeastError});
  std::sort(results.begin(), results.end(),
            [](const Result& a, const Result& b) { return a.seconds.median < b.seconds.median; });
  std::vector<Result> front;
  for (const Result& result : results) {
    if (result.has_failed() || (!front.empty() && result.error >= front.back().error)) continue;
    front.push_back(result);
  }
  return front;
}

/// The typical standard error of those that did not fail: what is below it is chance. 0 where nothing is random.
double floor_of(const Task& task, const std::vector<Result>& results) {
  std::vector<double> floors;
  for (const Result& result : results) {
    if (task.is_mean && !result.has_failed()) floors.push_back(result.floor);
  }
  return floors.empty() ? 0 : spread_of(floors).median;
}

Table table_of(const Task& task, const std::vector<Result>& results) {
  Table table{task.name,
              {{"method"},
               {"step", "s"},
               {task.error},
               {"standard error"},
               {"time per simulated second", "s"},
               {"lower quartile", "s"},
               {"upper quartile", "s"}},
              {}};
  for (const Result& r : results) {
    const Cell step = has_steps(*r.method) ? Cell(r.dt) : Cell("none"),
               error = r.has_failed() ? Cell("failed") : Cell(r.error);
    table.rows.push_back({r.method->name, step, error, r.floor, r.seconds.median, r.seconds.lower, r.seconds.upper});
  }
  return table;
}

/// Whether single precision is worth a line: somewhere its error is twice the double's, by more than chance.
bool differs(const std::vector<Result>& results, size_t first, double floor) {
  const std::string& name = results[first].method->name;
  const std::string of_double = name.substr(0, name.rfind(", float"));
  for (size_t k = first; k < results.size() && results[k].method == results[first].method; ++k) {
    const auto other = std::find_if(results.begin(), results.end(), [&](const Result& r) {
      return r.method->name == of_double && r.dt == results[k].dt;
    });
    if (results[k].has_failed() != other->has_failed()) return true;
    if (results[k].error > 2 * other->error + 3 * floor) return true;
  }
  return false;
}

Chart chart_of(const Task& task, const std::vector<Result>& results) {
  const double floor = floor_of(task, results);
  Chart chart{task.name, task.title, {"time per simulated second", "s", Scale::log}, {task.error, "", Scale::log}, {},
              {},        {}};
  for (size_t k = 0; k < results.size();) {
    const ContactMethod* method = results[k].method;
    Series series = series_of(*method);
    const bool is_shown = !series.is_dashed || differs(results, k, floor);
    for (; k < results.size() && results[k].method == method; ++k) {
      const Result& r = results[k];
      series.points.push_back(
          {r.seconds.median, std::max(r.error, kLeastError), kNoNumber, kNoNumber, r.seconds.lower, r.seconds.upper});
    }
    if (is_shown) chart.series.push_back(series);
  }
  Series front{"Pareto front", "front", {}, Stroke::line}, chance{"chance", "theory", {}, Stroke::line};
  for (const Result& result : front_of(results, floor)) front.points.push_back({result.seconds.median, result.error});
  chart.series.push_back(front);
  const auto [least, most] = std::minmax_element(results.begin(), results.end(), [](const Result& a, const Result& b) {
    return a.seconds.median < b.seconds.median;
  });
  chance.points = {{least->seconds.median, floor}, {most->seconds.median, floor}};
  if (floor > 0) chart.series.push_back(chance);
  return chart;
}

/// At what order in the step restitution converges: the force begins with a kink, with a dashpot by a jump.
struct Order {
  const char *integrator, *law;
  double restitution, expected;
};

std::vector<Order> orders() {
  const double damped = restitution_to_overlap_end(0.1);
  return {{"velocity-verlet", "linear", 1, 3},
          {"velocity-verlet", "hertz", 1, 2.5},
          {"velocity-verlet", "linear", damped, 1},
          {"rk4", "hertz", 1, 2.5},
          {"rk4", "linear", damped, 2}};
}

Table order_table(Lab& lab) {
  Table table{"orders", {{"integrator"}, {"law"}, {"restitution"}, {"order measured"}, {"order expected"}}, {}};
  for (const Order& order : orders()) {
    const auto measured = lab.measure(key_of({"order", order.integrator, order.law, order.restitution}), [&] {
      return std::vector<double>{order_of_restitution(order.integrator, order.law, order.restitution)};
    });
    table.rows.push_back({order.integrator, order.law, order.restitution, measured[0], order.expected});
  }
  return table;
}

int64_t measurements(bool is_quick) {
  size_t count = 0;
  for (const Task& task : tasks()) {
    for (const ContactMethod& method : contact_methods()) {
      if (task.serves(method)) count += steps_of(task, method, is_quick).size();
    }
  }
  return static_cast<int64_t>(count) * repeats(is_quick) + static_cast<int64_t>(orders().size());
}

/// The fastest of a task that holds a tolerance; nullptr where none does.
const Result* fastest(const std::vector<Result>& front, double tolerance) {
  const auto found = std::find_if(front.begin(), front.end(), [&](const Result& r) { return r.error <= tolerance; });
  return found == front.end() ? nullptr : &*found;
}

/// Those that failed at every step: "stack – kinematic, event-driven"; empty where there are none.
std::string never_served(const Task& task, const std::vector<Result>& results) {
  std::vector<std::string> names;
  for (const ContactMethod& method : contact_methods()) {
    const auto is_served = [&](const Result& r) { return r.method == &method && !r.has_failed(); };
    const bool is_float = method.settings.precision == "float";
    if (is_float || !task.serves(method) || std::any_of(results.begin(), results.end(), is_served)) continue;
    names.push_back(method.name);
  }
  return names.empty() ? "" : " In " + task.name + " nothing came of " + join(names) + ".";
}

Findings run(Lab& lab) {
  Findings findings;
  std::string truths, failures;
  Table best{"fastest", {{"task"}, {"tolerance"}, {"method"}, {"step", "s"}, {"time per simulated second", "s"}}, {}};
  for (const Task& task : tasks()) {
    const std::vector<Result> results = results_of(lab, task), front = front_of(results, floor_of(task, results));
    findings.tables.push_back(table_of(task, results));
    findings.charts.push_back(chart_of(task, results));
    for (const double tolerance : kTolerances) {
      const Result* result = fastest(front, tolerance);
      best.rows.push_back({task.name, tolerance, result ? result->method->name : "none",
                           result ? result->dt : kNoNumber, result ? result->seconds.median : kNoNumber});
    }
    const Result* percent = fastest(front, 0.01);
    findings.answer += findings.answer.empty() ? "An error of one percent costs least: " : "; ";
    findings.answer += task.name + " – " + (percent ? percent->method->name : "nobody");
    failures += never_served(task, results);
    truths += (truths.empty() ? "" : "; ") + task.name + " – " + task.truth;
  }
  findings.answer += ".";
  findings.see =
      "Each point is a step, half as long as that to its left: to the right runs take longer, downwards they are more "
      "accurate. Bars are quartiles of the times; errors below 1e-10 are drawn there. Runs that stopped, or carry no "
      "weight, are × at the edge. Thin lines are other "
      "integrators and solvers of the response whose colour and marker they have; single precision is drawn, dashed, "
      "where it "
      "differs. Springs get stiffer with the step, so that a contact always lasts 20 steps; only in the first chart "
      "they stay "
      "the same. There a higher order earns little: the force begins with a jump, and RK4 keeps two of its four "
      "orders, Verlet "
      "one of two. Errors are against: " +
      truths + "." + failures;
  findings.tables.push_back(best);
  findings.tables.push_back(order_table(lab));
  return findings;
}

}  // namespace

Experiment work_precision_experiment() {
  return {"work-precision",
          "Speed against accuracy",
          "Which method, integrator, step and precision gives the least error in the least time?",
          80,
          2400,
          measurements,
          run};
}

}  // namespace ballpit
