// SPDX-License-Identifier: MIT
// The cost of accuracy: computation time per simulated second against error, for every response, integrator, step and
// precision.
#include "core/error.h"
#include "lab/experiments/accuracy.h"
#include "lab/experiments/experiments.h"
#include "response/pair_force.h"

namespace ballpit {

namespace {

constexpr double kTolerances[] = {0.1, 0.01, 0.001};
constexpr int kTaskRevision = 2;  // to be raised whenever a task measures something else

int repeats(bool is_quick) { return is_quick ? 3 : 5; }

/// All methods for a task, each with all its steps, the coarsest first; exact motion with one.
std::vector<Result> cases_of(const Task& task, bool is_quick) {
  std::vector<Result> cases;
  for (const ContactMethod* method : methods_of(task, is_quick)) {
    const int halvings = has_steps(*method) ? (is_quick ? task.quick_halvings : task.full_halvings) : 0;
    for (int k = 0; k <= halvings; ++k) cases.push_back({method, std::ldexp(task.coarsest, -k)});
  }
  return cases;
}

/// Measures all cases. Each repeat covers all methods and steps, so that other load on the machine affects all equally.
std::vector<Result> results_of(Lab& lab, const Task& task) {
  std::vector<Result> results = cases_of(task, lab.is_quick());
  std::vector<std::vector<double>> off(results.size()), seconds(results.size());
  for (int repeat = 0; repeat < repeats(lab.is_quick()); ++repeat) {
    const uint64_t seed = lab.seed() * 100 + static_cast<uint64_t>(repeat);
    for (size_t k = 0; k < results.size(); ++k) {
      const ContactMethod& method = *results[k].method;
      const double dt = results[k].dt;
      const auto key = key_of(task.name, kTaskRevision, method.name, dt, seed, lab.is_quick() ? "quick" : "full");
      const auto values = lab.time(key, [&] {
        const Trial trial = task.run(with_step(method, dt), seed, lab.is_quick());
        return std::vector<double>{trial.off, trial.seconds};
      });
      off[k].push_back(values[0]);
      seconds[k].push_back(values[1]);
    }
  }
  for (size_t k = 0; k < results.size(); ++k) {
    const Mean mean = mean_of(off[k]);
    results[k].error = std::isfinite(mean.value) ? std::fabs(mean.value) : kFailed;
    results[k].standard_error = mean.error;
    results[k].seconds = spread_of(seconds[k]);
  }
  return results;
}

/// The typical standard error of the results that did not fail: smaller errors are chance. 0 if nothing is random.
double floor_of(const Task& task, const std::vector<Result>& results) {
  std::vector<double> floors;
  for (const Result& result : results) {
    if (task.is_mean && !result.has_failed()) floors.push_back(result.standard_error);
  }
  return floors.empty() ? 0 : spread_of(floors).median;
}

Table table_of(const Task& task, const std::vector<Result>& results) {
  Table table{task.name,
              {"method", "step [s]", task.error, "standard error", "time per simulated second [s]",
               "lower quartile [s]", "upper quartile [s]"}};
  for (const Result& r : results) {
    const Cell step = has_steps(*r.method) ? Cell(r.dt) : Cell("none"),
               error = r.has_failed() ? Cell("failed") : Cell(r.error);
    table.add_row(r.method->name, step, error, r.standard_error, r.seconds.median, r.seconds.lower, r.seconds.upper);
  }
  return table;
}

/// Whether single precision differs from double: at some step its error is more than twice as large, and not by chance.
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
  Chart chart{task.name, task.title, Axis{"time per simulated second", "s", Scale::log},
              Axis{task.error, "", Scale::log}};
  double least = INFINITY, most = 0;  // [s] of results that did not fail
  for (const Result& r : results) {
    if (r.has_failed()) continue;
    least = std::min(least, r.seconds.median);
    most = std::max(most, r.seconds.median);
  }
  for (size_t k = 0; k < results.size();) {
    const ContactMethod* method = results[k].method;
    Series series = series_of(*method);
    const bool is_shown = !series.is_dashed || differs(results, k, floor);
    for (; k < results.size() && results[k].method == method; ++k) {
      const Result& r = results[k];
      if (r.has_failed()) {  // it has no comparable time
        series.points.push_back({std::clamp(r.seconds.median, least, most), r.error});
      } else {
        series.points.push_back(
            {r.seconds.median, std::max(r.error, kMinError), kNoNumber, kNoNumber, r.seconds.lower, r.seconds.upper});
      }
    }
    if (is_shown) chart.series.push_back(series);
  }
  drop_equal_labels(chart.series);
  Series front{"Pareto front", "front", {}, Stroke::line};
  for (const Result& result : front_of(results, floor)) front.points.push_back({result.seconds.median, result.error});
  if (front.points.size() > 1) chart.series.insert(chart.series.begin(), front);  // below what it joins
  if (floor > 0) chart.series.push_back({"chance", "theory", {{least, floor}, {most, floor}}, Stroke::line});
  return chart;
}

/// The order with which restitution converges. It is low because the force does not start smoothly; a dashpot's force
/// jumps.
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
  Table table{"orders", {"integrator", "law", "restitution", "order measured", "order expected"}, {}, true};
  for (const Order& order : orders()) {
    const double measured = lab.measure_number(key_of("order", order.integrator, order.law, order.restitution), [&] {
      return order_of_restitution(order.integrator, order.law, order.restitution);
    });
    table.add_row(order.integrator, order.law, order.restitution, measured, order.expected);
  }
  return table;
}

int64_t measurements(bool is_quick) {
  int64_t count = static_cast<int64_t>(orders().size());
  for (const Task& task : tasks()) count += repeats(is_quick) * std::ssize(cases_of(task, is_quick));
  return count;
}

/// The fastest of a task within a tolerance; nullptr if there is none.
const Result* fastest(const std::vector<Result>& front, double tolerance) {
  const auto found = std::ranges::find_if(front, [&](const Result& r) { return r.error <= tolerance; });
  return found == front.end() ? nullptr : &*found;
}

/// "kinematic; event-driven": the methods in double precision that failed at every step.
std::string never_served(const Task& task, const std::vector<Result>& results, bool is_quick) {
  std::vector<std::string> names;
  for (const ContactMethod* method : methods_of(task, is_quick)) {
    const bool is_served = std::any_of(results.begin(), results.end(),
                                       [&](const Result& r) { return r.method == method && !r.has_failed(); });
    if (method->settings.precision == Precision::float64 && !is_served) names.push_back(method->name);
  }
  return join(names, "; ");
}

/// "penalty, rk4: 12 µs", or why there is no result within the tolerance.
std::string text_of(const Result* result, bool is_chance) {
  if (!result) return is_chance ? "chance is larger" : "nobody";
  const double micro = 1e6 * result->seconds.median;
  return result->method->name + ": " +
         (micro < 1000 ? three_digits(micro) + " µs" : three_digits(micro / 1000) + " ms");
}

/// How often each name occurs: "impulse in 5 of 19 scenes, penalty in 3; in 11 nobody comes that close, or chance is
/// larger".
std::string counts_of(const std::vector<std::string>& names, size_t scenes) {
  std::vector<std::pair<std::string, int>> counts;
  for (const std::string& name : names) {
    auto found = std::ranges::find(counts, name, &std::pair<std::string, int>::first);
    if (found == counts.end()) found = counts.insert(found, {name, 0});
    ++found->second;
  }
  std::ranges::stable_sort(counts, std::greater{}, &std::pair<std::string, int>::second);
  std::vector<std::string> texts;
  for (const auto& [name, count] : counts) texts.push_back(phrase("{} in {}", name, count));
  if (!texts.empty()) texts.front() += phrase(" of {} scenes", scenes);
  const size_t left = scenes - names.size();
  return join(texts) + (left > 0 ? phrase("; in {} nobody comes that close, or chance is larger", left) : "");
}

Findings measure(Lab& lab) {
  Findings findings;
  Table best{"fastest", {"scene", "within 10 %", "within 1 %", "within 0.1 %"}, {}, true};
  Table scenes{"scenes", {"scene", "what is off", "against", "nothing came of"}, {}, true};
  std::vector<std::string> winners;  // at a percent
  for (const Task& task : tasks()) {
    const std::vector<Result> results = results_of(lab, task);
    const double floor = floor_of(task, results);
    const std::vector<Result> front = front_of(results, floor);
    findings.tables.push_back(table_of(task, results));
    findings.charts.push_back(chart_of(task, results));
    std::vector<Cell>& row = best.rows.emplace_back(1, task.name);
    for (const double tolerance : kTolerances) row.emplace_back(text_of(fastest(front, tolerance), tolerance < floor));
    const Result* winner = fastest(front, 0.01);
    if (winner) winners.emplace_back(name_of(winner->method->settings.response));
    scenes.add_row(task.name, task.error, task.truth, never_served(task, results, lab.is_quick()));
  }
  findings.values = {{"winners", counts_of(winners, tasks().size())}};
  findings.tables.insert(findings.tables.end(), {best, scenes, order_table(lab)});
  return findings;
}

}  // namespace

std::vector<const ContactMethod*> methods_of(const Task& task, bool is_quick) {
  std::vector<const ContactMethod*> methods;
  for (const ContactMethod& method : contact_methods()) {
    const bool is_left_out = is_quick && method.settings.precision == Precision::float32 && !is_float_of_main(method);
    if (task.serves(method) && !is_left_out) methods.push_back(&method);
  }
  return methods;
}

std::vector<Result> front_of(std::vector<Result> results, double floor) {
  for (Result& result : results) result.error = std::max({result.error, floor, kMinError});
  std::ranges::sort(results, {}, [](const Result& result) { return result.seconds.median; });
  std::vector<Result> front;
  for (const Result& result : results) {
    if (result.has_failed() || (!front.empty() && result.error >= front.back().error)) continue;
    front.push_back(result);
  }
  return front;
}

Experiment work_precision_experiment() { return {"work-precision", 70, 1800, measurements, measure}; }

}  // namespace ballpit
