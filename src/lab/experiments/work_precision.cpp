// SPDX-License-Identifier: MIT
// What accuracy costs: time per simulated second against error, of every response, integrator, step and precision.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/results.h"
#include "lab/key.h"
#include "simulate/response/damping.h"

namespace ballpit {

namespace {

constexpr double kTolerances[] = {0.1, 0.01, 0.001};

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
    table.rows.push_back(
        {r.method->name, step, error, r.standard_error, r.seconds.median, r.seconds.lower, r.seconds.upper});
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
  drop_equal_labels(chart.series);
  Series front{"Pareto front", "front", {}, Stroke::line}, chance{"chance", "theory", {}, Stroke::line};
  for (const Result& result : front_of(results, floor)) front.points.push_back({result.seconds.median, result.error});
  const auto [least, most] = std::minmax_element(results.begin(), results.end(), [](const Result& a, const Result& b) {
    return a.seconds.median < b.seconds.median;
  });
  chance.points = {{least->seconds.median, floor}, {most->seconds.median, floor}};
  chart.series.insert(chart.series.begin(), front);  // below what it joins
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
  Table table{"orders", {{"integrator"}, {"law"}, {"restitution"}, {"order measured"}, {"order expected"}}, {}, true};
  for (const Order& order : orders()) {
    const auto measured = lab.measure(key_of({"order", order.integrator, order.law, order.restitution}), [&] {
      return std::vector<double>{order_of_restitution(order.integrator, order.law, order.restitution)};
    });
    table.rows.push_back({order.integrator, order.law, order.restitution, measured[0], order.expected});
  }
  return table;
}

int64_t measurements(bool is_quick) {
  int64_t count = static_cast<int64_t>(orders().size());
  for (const Task& task : tasks()) count += trial_count(task, is_quick);
  return count;
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
                           result && has_steps(*result->method) ? result->dt : kNoNumber,
                           result ? result->seconds.median : kNoNumber});
    }
    const Result* percent = fastest(front, 0.01);
    findings.answer += findings.answer.empty() ? "An error of one percent costs least: " : "; ";
    findings.answer += task.name + " – " + (percent ? percent->method->name : "nobody");
    failures += never_served(task, results);
    truths += (truths.empty() ? "" : "; ") + task.name + " – " + task.truth;
  }
  findings.answer += ".";
  findings.see =
      "Each point is a step, half as long as that to its left: to the right runs take longer, downwards they are "
      "more accurate. Bars are quartiles of the times; errors below 1e-10 are drawn there. Runs that stopped, or "
      "carry no weight, are × at the edge. Thin lines are other integrators and solvers of the response whose "
      "colour and marker they have, without a label where they end like its own; single precision is drawn, "
      "dashed, where it differs, and counts in the Pareto front. Springs get stiffer with the step, so that a "
      "contact always lasts 20 steps; only in the first chart they stay the same. There a higher order earns "
      "little: the force begins with a jump, and RK4 keeps two of its four orders, Verlet one of two. Errors are "
      "against: " +
      truths + "." + failures;
  best.is_shown = true;
  findings.tables.push_back(best);
  findings.tables.push_back(order_table(lab));
  return findings;
}

}  // namespace

Experiment work_precision_experiment() {
  return {"work-precision",
          "Speed against accuracy",
          "Which method, integrator, step and precision gives the least error in the least time?",
          70,
          1800,
          measurements,
          run};
}

}  // namespace ballpit
