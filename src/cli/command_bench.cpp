// SPDX-License-Identifier: MIT
// ballpit bench: time per step by method, backend, threads and number of spheres, on a gas of elastic spheres.
#include <algorithm>
#include <array>
#include <iostream>

#include <nlohmann/json.hpp>

#include "cli/bench_summary.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "measure/machine.h"
#include "measure/step_timing.h"
#include "methods/methods.h"

namespace ballpit {

namespace {

/// The shared options that change what a step costs, and that the command does not vary by itself.
constexpr std::array<std::string_view, 7> kStepSettings{"cell-size", "axis",       "table",    "skin",
                                                        "response",  "integrator", "precision"};

/// All but "auto".
template <class Enum>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for (const std::string_view name : kNames<Enum>) {
    if (name != "auto") names.emplace_back(name);
  }
  return names;
}

/// Each once, in the order given.
template <class Enum>
std::vector<std::string> parse_names(std::string_view option, const std::string& text) {
  std::vector<std::string> names;
  for (const std::string& name : split_list(text)) {
    parse_choice(option, name, names_of<Enum>());
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// Each once, ascending.
std::vector<int64_t> parse_integers(std::string_view option, const std::string& text, int64_t low, int64_t high) {
  std::vector<int64_t> numbers;
  for (const std::string& item : split_list(text)) numbers.push_back(parse_integer(option, item, low, high));
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Those of these names, or where there are none, all that can serve here.
std::vector<Backend> choose_backends(const std::vector<std::string>& names) {
  std::vector<Backend> backends;
  for (const Backend& backend : {cpu_backend(), cuda_backend()}) {
    const bool is_named = std::find(names.begin(), names.end(), backend.name) != names.end();
    const bool can_serve = backend.unavailable_reason.empty();
    if (is_named && !can_serve) {
      throw UserError("--backends", backend.name + ", which cannot serve here: " + backend.unavailable_reason, "cpu");
    }
    if (is_named || (names.empty() && can_serve)) backends.push_back(backend);
  }
  return backends;
}

class BenchCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override {
    const auto add = [&](const char* name, std::string& text, const std::string& help, const char* type) {
      return command.add_option(name, text, help)->type_name(type);
    };
    add("--counts", counts_, "numbers of spheres", "N,…")->shows_default();
    methods_option_ =
        add("--methods", methods_, "some of " + join(names_of<BroadPhase>()) + "; default: all", "NAME,…");
    threads_option_ =
        add("--threads", threads_, "numbers of CPU threads, 0 for all cores; default: 1 and all cores", "N,…");
    backends_option_ = add("--backends", backends_,
                           "some of " + join(names_of<BackendName>()) + "; default: all that can serve here", "NAME,…");
    add("--repeat", repeat_, "blocks of steps to measure of each", "N")->shows_default();
    add("--limit", limit_, "longest time for each; what would need longer is skipped", "SECONDS")->shows_default();
    command.add_flag("--stages", stages_, "show each stage that takes a hundredth of a step, or more");
    command.add_flag("--json", json_, "print one JSON object");
    settings_.add_to(command, "Simulation", kStepSettings);
  }

  void run() override {
    catch_interrupts();
    const TimingPlan plan = make_plan();
    warn_of_small_cells(plan.settings);
    const std::vector<StepTiming> timings = measure(plan);
    const auto summary = summarize(plan, timings);
    if (json_) {
      print_json(summary);
    } else {
      print_table(summary, stages_);
    }
  }

 private:
  TimingPlan make_plan() const {
    TimingPlan plan;
    plan.counts = parse_integers("--counts", counts_, 1, 100'000'000);
    plan.blocks = static_cast<int>(parse_integer("--repeat", repeat_, 1, 1000));
    plan.limit = parse_number("--limit", limit_, 1e-3, 1e6);
    apply_given(plan.settings, settings_.given());
    check_given(plan.settings, settings_.given());
    std::vector<std::string> methods = names_of<BroadPhase>(), backends;
    if (methods_option_->is_given()) methods = parse_names<BroadPhase>("--methods", methods_);
    if (backends_option_->is_given()) backends = parse_names<BackendName>("--backends", backends_);
    const std::vector<int> threads = choose_threads();
    for (const Backend& backend : choose_backends(backends)) {
      for (const int t : backend.name == "cpu" ? threads : std::vector<int>{0}) {
        for (const std::string& method : methods) plan.cases.push_back({method, backend, t});
      }
    }
    return plan;
  }

  std::vector<int> choose_threads() const {
    std::vector<int> threads{1, thread_count(0)};
    if (threads_option_->is_given()) {
      threads.clear();
      for (const int64_t t : parse_integers("--threads", threads_, 0, 256)) {
        threads.push_back(thread_count(static_cast<int>(t)));
      }
    }
    std::sort(threads.begin(), threads.end());
    threads.erase(std::unique(threads.begin(), threads.end()), threads.end());
    return threads;
  }

  static std::vector<StepTiming> measure(const TimingPlan& plan) {
    const auto total = static_cast<int64_t>(plan.cases.size() * plan.counts.size());
    Progress progress("entries", total);
    const auto tell = [&](int64_t done) { progress.show(done); };
    std::vector<StepTiming> timings = time_steps(plan, tell, was_interrupted);
    if (!was_interrupted()) return timings;
    throw RunError("bench",
                   "interrupted after " + std::to_string(timings.size()) + " of " + std::to_string(total) + " entries");
  }

  SettingOptions settings_;
  std::string counts_ = "1000,10000,100000";
  std::string methods_, threads_, backends_;
  std::string repeat_ = "5";
  std::string limit_ = "5";
  CommandOption* methods_option_ = nullptr;
  CommandOption* threads_option_ = nullptr;
  CommandOption* backends_option_ = nullptr;
  bool stages_ = false;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_bench_command() { return std::make_unique<BenchCommand>(); }

}  // namespace ballpit
