// SPDX-License-Identifier: MIT
// ballpit bench: time per step by method, backend, threads and number of spheres, on a gas of elastic spheres.
#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/progress.h"
#include "cli/summary.h"
#include "core/interrupt.h"
#include "measure/machine.h"
#include "measure/statistics.h"
#include "measure/step_timing.h"
#include "methods/methods.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

/// The settings that affect a step and that the command does not vary itself.
constexpr std::array<std::string_view, 7> kStepSettings{"cell-size", "axis",       "table",    "skin",
                                                        "response",  "integrator", "precision"};

/// All but "auto".
template <class Enum>
std::vector<std::string> names_of() {
  return {kNames<Enum>.begin() + 1, kNames<Enum>.end()};
}

/// Each once, in the order given.
std::vector<std::string> parse_choices(std::string_view option, const std::string& text,
                                       const std::vector<std::string>& allowed) {
  std::vector<std::string> names;
  for (const std::string& name : split_list(text)) {
    parse_choice(option, name, allowed);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

template <class T>
void keep_each_once(std::vector<T>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

template <class T>
std::vector<T> parse_numbers(std::string_view option, const std::string& text, const Range<T>& range) {
  std::vector<T> numbers;
  for (const std::string& item : split_list(text)) numbers.push_back(parse_number(option, item, range));
  return numbers;
}

/// The backends of these names; without names, all that can serve here.
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

/// How many times as fast as the first method at the same count, backend and threads; empty if that was skipped.
std::optional<double> speedup_of(const StepTiming& timing, const std::vector<StepTiming>& all) {
  const auto first = std::find_if(all.begin(), all.end(), [&](const StepTiming& other) {
    return other.count == timing.count && other.which.backend.name == timing.which.backend.name &&
           other.which.threads == timing.which.threads;
  });
  if (first->seconds.empty()) return std::nullopt;
  return spread_of(first->seconds).median / spread_of(timing.seconds).median;
}

Json json_of(const StepTiming& timing, const std::vector<StepTiming>& all) {
  Json entry{{"count", timing.count}, {"method", timing.which.method}, {"backend", timing.which.backend.name}};
  entry["threads"] = timing.which.threads > 0 ? Json(timing.which.threads) : Json();
  if (!timing.skipped.empty()) {
    entry["skipped"] = timing.skipped;
    return entry;
  }
  const Spread spread = spread_of(timing.seconds);
  const std::optional<double> speedup = speedup_of(timing, all);
  entry["seconds"] = spread.median;
  entry["seconds_min"] = spread.least;
  entry["seconds_quartiles"] = {spread.lower, spread.upper};
  entry["speedup"] = speedup ? Json(*speedup) : Json();
  entry["steps"] = timing.steps;
  entry["contacts"] = timing.contacts;
  entry["candidates"] = timing.candidates;
  entry["stages"] = Json::array();
  for (const StepStage& stage : timing.stages) {
    entry["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"launches", stage.launches}});
  }
  return entry;
}

std::string row_of(const StepTiming& timing, const std::vector<StepTiming>& all) {
  const StepCase& which = timing.which;
  const std::string start = fmt::format("{:9}  {:<15} {:<7} {:>7}  ", timing.count, which.method, which.backend.name,
                                        which.threads > 0 ? std::to_string(which.threads) : "-");
  if (!timing.skipped.empty()) return fmt::format("{}skipped: {}\n", start, timing.skipped);
  const Spread spread = spread_of(timing.seconds);
  const std::optional<double> speedup = speedup_of(timing, all);
  return fmt::format("{}{:10.4f}  {:9.4f} to {:9.4f}  {:11.1f}{}\n", start, 1e3 * spread.median, 1e3 * spread.lower,
                     1e3 * spread.upper, 1e9 * spread.median / static_cast<double>(timing.count),
                     speedup ? fmt::format("  {:7.1f}", *speedup) : "");
}

/// The stages that take at least a hundredth of a step.
std::string stages_of(const StepTiming& timing) {
  if (timing.seconds.empty()) return "";
  const double least = 0.01 * spread_of(timing.seconds).median;
  std::string text;
  for (const StepStage& stage : timing.stages) {
    if (stage.seconds >= least) text += fmt::format("{:9}    {:<22} {:14.4f}\n", "", stage.name, 1e3 * stage.seconds);
  }
  return text;
}

/// Machine, scene, and an entry for each timing.
Json json_of(const TimingPlan& plan, const std::vector<StepTiming>& timings) {
  Json entries = Json::array();
  for (const StepTiming& timing : timings) entries.push_back(json_of(timing, timings));
  return {{"machine", describe_machine()}, {"volume_fraction", kGasVolumeFraction}, {"dt", kGasStep},
          {"repeat", plan.blocks},         {"baseline", plan.cases.front().method}, {"entries", entries}};
}

std::string text_of(const TimingPlan& plan, const std::vector<StepTiming>& timings, bool with_stages) {
  const Json machine = describe_machine();
  const auto known = [&](const char* key) { return machine[key].get<std::string>(); };
  std::string text =
      fmt::format("{}, {} cores{}; {}, {}\n", known("cpu"), machine["cores"].dump(),
                  machine.contains("cuda") ? "; " + known("cuda") : "", known("compiler"), known("build_type"));
  text += fmt::format(
      "a gas of equal elastic spheres, {:.0f} % of the volume; medians and quartiles of {} blocks of steps\n"
      "speedup: against {} on the same processor\n\n",
      100 * kGasVolumeFraction, plan.blocks, plan.cases.front().method);
  text += fmt::format("{:>9}  {:<22} {:<7} {:>7}  {:>10}  {:>22}  {:>11}  {:>7}\n", "spheres", "method", "backend",
                      "threads", "ms a step", "quartiles", "ns a sphere", "speedup");
  for (const StepTiming& timing : timings) {
    text += row_of(timing, timings);
    if (with_stages) text += stages_of(timing);
  }
  return text;
}

class BenchCommand {
 public:
  BenchCommand() {
    plan_.counts = {1000, 10'000, 100'000};
    for (const std::string& name : names_of<BroadPhase>()) {
      if (!is_of_lecture(named<BroadPhase>(name))) methods_.push_back(name);
    }
  }

  void add_options(CommandOptions& command) {
    command.add({"--counts", "N,…", "numbers of spheres", fmt::format("{}", fmt::join(plan_.counts, ","))},
                [this](const std::string& text) {
                  plan_.counts = parse_numbers("--counts", text, Range{int64_t{1}, int64_t{100'000'000}});
                });
    const std::vector<std::string> known = names_of<BroadPhase>();
    command.add({"--methods", "NAME,…", "some of " + join(known) + "; default: all but those of the lecture"},
                [this, known](const std::string& text) { methods_ = parse_choices("--methods", text, known); });
    command.add({"--threads", "N,…", "numbers of CPU threads, 0 for all cores; default: 1 and all cores"},
                [this](const std::string& text) {
                  threads_ = parse_numbers("--threads", text, Range{0, 256});
                });
    command.add(
        {"--backends", "NAME,…", "some of " + join(names_of<BackendName>()) + "; default: all that can serve here"},
        [this](const std::string& text) { backends_ = parse_choices("--backends", text, names_of<BackendName>()); });
    command.add_number({"--repeat", "N", "blocks of steps to measure of each"}, plan_.blocks, Range{1, 1000});
    command.add_number({"--limit", "SECONDS", "longest time for each; sizes predicted to exceed it are skipped"},
                       plan_.limit, Range{1e-3, 1e6});
    command.add_flag("--stages", stages_, "show each stage that takes a hundredth of a step, or more");
    command.add_flag("--json", json_, "print one JSON object");
    add_settings(command, "Simulation", given_, kStepSettings);
  }

  void run() {
    catch_interrupts();
    complete_plan();
    warn_of_small_cells(plan_.settings);
    const std::vector<StepTiming> timings = measure();
    print(json_, json_of(plan_, timings), text_of(plan_, timings, stages_));
  }

 private:
  void complete_plan() {
    keep_each_once(plan_.counts);
    for (int& t : threads_) t = thread_count(t);
    keep_each_once(threads_);
    apply_given(plan_.settings, given_);
    check_given(plan_.settings, given_);
    for (const Backend& backend : choose_backends(backends_)) {
      for (const int t : backend.name == "cpu" ? threads_ : std::vector<int>{0}) {
        for (const std::string& method : methods_) plan_.cases.push_back({method, backend, t});
      }
    }
  }

  std::vector<StepTiming> measure() const {
    const size_t total = plan_.cases.size() * plan_.counts.size();
    Progress progress("entries", static_cast<int64_t>(total));
    std::vector<StepTiming> timings = time_steps(
        plan_, [&](int64_t done) { progress.show(done); }, was_interrupted);
    if (!was_interrupted()) return timings;
    throw RunError("bench", fmt::format("interrupted after {} of {} entries", timings.size(), total));
  }

  std::vector<GivenOption> given_;
  TimingPlan plan_;
  std::vector<std::string> methods_, backends_;
  std::vector<int> threads_{1, 0};
  bool stages_ = false, json_ = false;
};

}  // namespace

std::function<void()> make_bench_command(CommandOptions& options) { return make_command<BenchCommand>(options); }

}  // namespace ballpit
