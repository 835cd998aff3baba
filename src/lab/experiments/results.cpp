// SPDX-License-Identifier: MIT
#include "lab/experiments/results.h"

#include <algorithm>
#include <limits>

#include "lab/charts/table.h"

namespace ballpit {

namespace {

constexpr int kTaskRevision = 2;  // to be raised whenever a task measures something else

int repeats(bool is_quick) { return is_quick ? 3 : 5; }

/// The steps of a method in a task; only the coarsest for exact motion.
std::vector<double> steps_of(const Task& task, const ContactMethod& method, bool is_quick) {
  const int halvings = has_steps(method) ? (is_quick ? task.quick_halvings : task.full_halvings) : 0;
  std::vector<double> steps;
  for (int k = 0; k <= halvings; ++k) steps.push_back(std::ldexp(task.coarsest, -k));
  return steps;
}

/// The trials of each method and step.
std::vector<std::vector<Trial>> trials_of(Lab& lab, const Task& task) {
  std::vector<std::vector<Trial>> trials;
  for (int repeat = 0; repeat < repeats(lab.is_quick()); ++repeat) {
    size_t which = 0;
    for (const ContactMethod* method : methods_of(task, lab.is_quick())) {
      for (const double dt : steps_of(task, *method, lab.is_quick())) {
        const uint64_t seed = lab.seed() * 100 + static_cast<uint64_t>(repeat);
        const auto key = key_of(task.name, kTaskRevision, method->name, dt, seed, lab.is_quick() ? "quick" : "full");
        const auto values = lab.time(key, [&] {
          const Trial trial = task.run(*method, dt, seed, lab.is_quick());
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

}  // namespace

std::vector<const ContactMethod*> methods_of(const Task& task, bool is_quick) {
  std::vector<const ContactMethod*> methods;
  for (const ContactMethod& method : contact_methods()) {
    const bool is_left_out = is_quick && method.settings.precision == Precision::float32 && !is_float_of_main(method);
    if (task.serves(method) && !is_left_out) methods.push_back(&method);
  }
  return methods;
}

std::vector<Result> results_of(Lab& lab, const Task& task) {
  const auto trials = trials_of(lab, task);
  std::vector<Result> results;
  for (const ContactMethod* method : methods_of(task, lab.is_quick())) {
    for (const double dt : steps_of(task, *method, lab.is_quick())) {
      results.push_back(result_of(*method, dt, trials[results.size()]));
    }
  }
  return results;
}

std::vector<Result> front_of(std::vector<Result> results, double floor) {
  for (Result& result : results) result.error = std::max({result.error, floor, kMinError});
  std::sort(results.begin(), results.end(),
            [](const Result& a, const Result& b) { return a.seconds.median < b.seconds.median; });
  std::vector<Result> front;
  for (const Result& result : results) {
    if (result.has_failed() || (!front.empty() && result.error >= front.back().error)) continue;
    front.push_back(result);
  }
  return front;
}

double floor_of(const Task& task, const std::vector<Result>& results) {
  std::vector<double> floors;
  for (const Result& result : results) {
    if (task.is_mean && !result.has_failed()) floors.push_back(result.standard_error);
  }
  return floors.empty() ? 0 : spread_of(floors).median;
}

bool has_steps(const ContactMethod& method) { return method.settings.response != Response::event_driven; }

int64_t trial_count(const Task& task, bool is_quick) {
  size_t count = 0;
  for (const ContactMethod* method : methods_of(task, is_quick)) count += steps_of(task, *method, is_quick).size();
  return static_cast<int64_t>(count) * repeats(is_quick);
}

}  // namespace ballpit
