// SPDX-License-Identifier: MIT
#include "lab/measure/regret.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "choose/detection.h"
#include "core/numbers.h"
#include "measure/search_costs.h"
#include "measure/statistics.h"

namespace ballpit {

namespace {

/// A line of the grid.
struct Line {
  std::string_view name;
  Response response;
  void (*apply)(Settings&);
};

constexpr std::array kLines{
    Line{"event-driven", Response::event_driven, [](Settings&) {}},
    Line{"position-based", Response::position_based, [](Settings&) {}},
    Line{"position-based, 4", Response::position_based, [](Settings& s) { s.iterations = 4; }},
    Line{"impulse, 1", Response::impulse, [](Settings& s) { s.iterations = 1; }},
    Line{"impulse, 4", Response::impulse, [](Settings& s) { s.iterations = 4; }},
    Line{"impulse, 16", Response::impulse, [](Settings& s) { s.iterations = 16; }},
    Line{"impulse, gauss-seidel", Response::impulse, [](Settings& s) { s.solver = Solver::gauss_seidel; }},
    Line{"impulse, swept", Response::impulse, [](Settings& s) { s.is_swept = true; }},
    Line{"penalty", Response::penalty, [](Settings& s) { s.integrator = Integrator::symplectic_euler; }},
    Line{"penalty, verlet", Response::penalty, [](Settings& s) { s.integrator = Integrator::velocity_verlet; }},
};

constexpr int kCoarsest = 50, kHalvings = 12;  // steps of the duration
constexpr double kPatience = 20;               // [s] of computing for a run of the grid

Settings point(const Line& line, int halving, const Needs& needs, Precision precision) {
  Settings settings;
  settings.broadphase = BroadPhase::automatic;
  settings.response = line.response;
  settings.precision = precision;
  settings.costs = search_costs(cpu_backend(), precision);
  settings.dt = std::min(10.0, needs.duration / (kCoarsest * std::pow(2.0, halving)));
  line.apply(settings);
  return settings;
}

/// Effects have no figures: what cannot show them is not in the grid.
bool shows_effects(const Scene& scene, const Needs& needs, const SceneNumbers& numbers, const Settings& settings) {
  const RuleCase c{scene, needs, numbers, settings};
  for (const Rule& rule : rules()) {
    const bool is_of_effects = rule.name == "contact-time" || rule.name == "order" || rule.name == "resolved";
    if (is_of_effects && !rule.objection(c).empty()) return false;
  }
  return true;
}

struct Best {
  std::string method;
  Settings settings;
  double cost = INFINITY;
};

/// The coarsest step of a line that holds together with the next one, if it is cheaper than the best so far.
void find_best(const Line& line, const Scene& scene, const Needs& needs, const Truth& truth,
               const SceneNumbers& numbers, Precision precision, Best& best) {
  FullRun before;
  Settings settings_before;
  for (int halving = 0; halving < kHalvings; ++halving) {
    Settings settings = point(line, halving, needs, precision);
    if (settings.dt < 1e-12) return;
    if (!shows_effects(scene, needs, numbers, settings)) continue;
    settings.threads = cheapest_threads(scene, needs, settings, {});
    const bool is_exact = line.response == Response::event_driven;
    // The next finer step costs about twice as much; it only has to hold.
    const double limit = std::min(kPatience, std::max(2.5 * best.cost, 10 * kEqualCosts));
    const FullRun run = full_run(scene, needs, truth, settings, limit);
    if (is_exact && run.holds && run.seconds < best.cost) best = {std::string(line.name), settings, run.seconds};
    if (is_exact) return;
    if (run.holds && before.holds) {
      if (before.seconds < best.cost) best = {std::string(line.name), settings_before, before.seconds};
      return;
    }
    if (run.seconds >= limit) return;
    if (!run.holds && run.seconds > 1.2 * std::max(best.cost, kEqualCosts)) return;
    before = run;
    settings_before = settings;
  }
}

/// Other searches for the best point of the grid: broad phases, with and without a candidate list, on one thread or
/// all.
void find_best_search(const Scene& scene, const Needs& needs, Best& best) {
  if (best.settings.response == Response::event_driven || best.cost <= kEqualCosts) return;
  const Settings motion = best.settings;
  for (const BroadPhase method :
       {BroadPhase::brute_force, BroadPhase::sort_and_sweep, BroadPhase::linked_cell, BroadPhase::sorted_grid}) {
    for (const double skin : {0.0, 0.1, 0.3}) {
      for (const int threads : {0, 1}) {
        Settings settings = motion;
        settings.broadphase = method;
        settings.skin = skin;
        settings.threads = threads;
        const FullRun run = full_run(scene, needs, {}, settings, best.cost);
        if (run.seconds < best.cost) best.cost = run.seconds, best.settings = settings;
      }
    }
  }
}

double median_cost(const std::vector<double>& values) { return spread_of(values).median; }

}  // namespace

FullRun full_run(const Scene& scene, const Needs& needs, const Truth& truth, const Settings& settings, double limit) {
  const PilotResult result = run_pilot({scene, needs, truth, needs.duration, limit, INFINITY}, settings);
  FullRun run{false, result.cost, result.stopped};
  if (!result.is_complete && run.why.empty()) run = {false, limit, "takes too long"};
  if (!run.why.empty()) return run;
  const std::vector<Tolerance> tolerances = tolerances_of(needs);
  for (size_t k = 0; k < tolerances.size(); ++k) {
    // At the end, not near it.
    const double error = tolerances[k].name == "max_overlap" ? result.end_overlap : result.errors[k];
    if (error <= tolerances[k].allowed) continue;
    run.why += fmt::format("{}{} {}, allowed {}", run.why.empty() ? "" : "; ", tolerances[k].name, three_digits(error),
                           three_digits(tolerances[k].allowed));
  }
  run.holds = run.why.empty();
  return run;
}

Truth full_truth(const Scene& scene, const Needs& needs) {
  if (!needs.path_tolerance && needs.observables.empty()) return {};
  const Settings settings = point(kLines[0], 3, needs, Precision::float64);
  const SceneNumbers numbers = numbers_of(scene);
  if (!first_objection({scene, needs, numbers, settings}, {RuleKind::method})) {
    return run_pilot({scene, needs, {}, needs.duration, INFINITY, INFINITY}, settings).truth;
  }
  const Settings springs = point(kLines[9], kHalvings + 2, needs, Precision::float64);
  return run_pilot({scene, needs, {}, needs.duration, INFINITY, INFINITY}, springs).truth;
}

std::vector<std::string> judged_methods() {
  std::vector<std::string> names;
  for (const Variant& variant : variants()) names.emplace_back(variant.name);
  for (const Line& line : kLines) {
    if (std::ranges::find(names, line.name) == names.end()) names.emplace_back(line.name);
  }
  return names;
}

double Judged::regret() const {
  if (!has_choice) return has_valid ? INFINITY : 1;
  return std::max(cost, kEqualCosts) / std::max(best_cost, kEqualCosts);
}

Judged judge(std::string_view family, const Scene& scene, double budget) {
  constexpr int kRepeats = 5;
  Judged judged{std::string(family), scene.bodies.size()};
  const Needs needs = effective_needs(scene).needs;
  const Choice choice = choose({scene, {}, budget});
  const Truth truth = full_truth(scene, needs);
  judged.has_choice = choice.chosen.has_value();
  judged.chosen_in = choice.seconds;
  Best best;
  if (choice.chosen) {
    const FullRun run = full_run(scene, needs, truth, choice.chosen->settings, INFINITY);
    judged.holds = run.holds;
    judged.why = run.why;
    judged.method = choice.chosen->method;
    if (run.holds) best.cost = run.seconds, best.method = judged.method, best.settings = choice.chosen->settings;
  } else {
    judged.why = choice.reason;
  }
  const bool needs_double =
      std::ranges::any_of(tolerances_of(needs), [](const Tolerance& t) { return t.allowed < 1e-4; });
  for (const Line& line : kLines) {
    find_best(line, scene, needs, truth, choice.numbers, Precision::float32, best);
    if (needs_double && line.response != Response::event_driven) {
      find_best(line, scene, needs, truth, choice.numbers, Precision::float64, best);
    }
  }
  judged.has_valid = std::isfinite(best.cost);
  if (judged.has_valid) find_best_search(scene, needs, best);
  judged.best_method = best.method;
  if (!choice.chosen || !judged.has_valid) return judged;
  std::vector<double> own, others;
  for (int k = 0; k < kRepeats; ++k) {  // in turns, so that other load affects both equally
    own.push_back(full_run(scene, needs, {}, choice.chosen->settings, INFINITY).seconds);
    others.push_back(full_run(scene, needs, {}, best.settings, INFINITY).seconds);
  }
  judged.cost = median_cost(own);
  judged.best_cost = std::min(median_cost(others), judged.holds ? judged.cost : INFINITY);
  return judged;
}

}  // namespace ballpit
