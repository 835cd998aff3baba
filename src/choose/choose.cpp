// SPDX-License-Identifier: MIT
#include "choose/choose.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "choose/detection.h"
#include "choose/search.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/numbers.h"
#include "core/phrase.h"

namespace ballpit {

namespace {

/// Makes a choice from what a search has tried.
class Chooser {
 public:
  explicit Chooser(const ChoiceRequest& request) : request_(request) {
    choice_.numbers = numbers_of(request.scene);
    choice_.needs = effective_needs(request.scene);
    check_observables(choice_.needs.needs);
    choice_.tolerances = tolerances_of(choice_.needs.needs);
  }

  Choice choose() {
    const auto begin = std::chrono::steady_clock::now();
    Search search(request_, choice_.needs.needs, choice_.numbers);
    search.run();
    choice_.ruled_out = std::move(search.ruled_out);
    choice_.tried = search.tried;
    choice_.pilot_spheres = search.part().bodies.size();
    choice_.is_out_of_time = search.is_out_of_time();
    conclude(search);
    choice_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(choice_);
  }

 private:
  const Needs& needs() const { return choice_.needs.needs; }

  void conclude(const Search& search) {
    const auto cost = [](const Attempt& attempt) { return std::max(attempt.cost, kEqualCosts); };
    const auto order = [](const Attempt& attempt) {
      return std::ranges::find(variants(), attempt.method, &Variant::name) - variants().begin();
    };
    const Attempt *best = nullptr, *nearest = nullptr;
    const auto is_cheaper = [&](const Attempt& a, const Attempt& b) {
      return std::tuple(!a.holds, cost(a), order(a), a.cost) < std::tuple(!b.holds, cost(b), order(b), b.cost);
    };
    for (const Attempt& attempt : choice_.tried) {
      if (std::isfinite(attempt.worst) && (nearest == nullptr || attempt.worst < nearest->worst)) nearest = &attempt;
      if (!attempt.holds && !attempt.may_hold) continue;
      if (best == nullptr || is_cheaper(attempt, *best)) best = &attempt;
    }
    if (best == nullptr && nearest != nullptr && nearest->is_close) best = nearest;  // better a small margin than none
    if (best == nullptr) {
      if (nearest != nullptr) choice_.nearest = *nearest;
      choice_.reason = reason_for_nothing();
      return;
    }
    choice_.chosen = *best;
    tune(search, static_cast<size_t>(best - choice_.tried.data()));
    list_dearer();
    list_unneeded();
    choice_.reason = reason();
  }

  /// Finds the cheapest search for the chosen motion.
  void tune(const Search& search, size_t index) {
    constexpr double kSeconds = 0.4;
    Attempt& chosen = *choice_.chosen;
    if (chosen.settings.response == Response::event_driven || chosen.cost <= kEqualCosts) return;
    Scene scene = search.part();
    scene.bodies = search.middle_of(index);
    if (scene.bodies.size() == 0) return;
    if (request_.stop.stop_requested()) throw Interrupted();
    const CheapestSearch cheapest =
        with_cheapest_search(scene, needs(), chosen.settings, request_.given, request_.scene.bodies.size(), kSeconds);
    chosen.settings = cheapest.settings;
    chosen.cost *= cheapest.ratio;
  }

  /// The cheapest attempt of each method that broke nothing, also of those given up for their cost, with its own steps
  /// and finer ones.
  void list_dearer() {
    constexpr int kHalvings = 10;
    const Attempt& chosen = *choice_.chosen;
    std::vector<std::pair<double, Settings>> list;
    for (const Variant& variant : variants()) {
      const Attempt* first = variant.name == chosen.method ? &chosen : nullptr;
      for (const Attempt& attempt : choice_.tried) {
        if (attempt.method != variant.name || !attempt.is_close || variant.name == chosen.method) continue;
        if (first == nullptr || attempt.cost < first->cost) first = &attempt;
      }
      if (first == nullptr) continue;
      Settings settings = first->settings;
      double cost = first->cost;
      for (int k = 0; k <= kHalvings; ++k, settings.dt /= 2, cost *= 2) {
        if (cost > chosen.cost && settings.dt > 1e-12) list.emplace_back(cost, settings);
        if (variant.response == Response::event_driven || is_given(request_.given, "dt")) break;
      }
    }
    std::ranges::stable_sort(list, {}, &std::pair<double, Settings>::first);
    for (auto& [cost, settings] : list) choice_.dearer.push_back(settings);
  }

  void list_unneeded() {
    const SceneNumbers& n = choice_.numbers;
    const Settings& s = choice_.chosen->settings;
    const bool is_exact = s.response == Response::event_driven;
    const auto add = [&](bool is_unneeded, const std::string& what) {
      if (is_unneeded) choice_.unneeded.push_back(what);
    };
    add(n.dimensions == 3 && n.is_planar_motion && n.count > 0, phrase("the third dimension: all motion is planar"));
    add(precision_of(s) == Precision::float32, phrase("double precision"));
    add(s.substeps == 1 && !is_exact, phrase("substeps"));
    add(!s.is_swept && !is_exact, phrase("swept contacts: the fastest sphere moves {} diameters in a step",
                                         local_number(three_digits(n.flight(s.dt)))));
    add(!is_exact && skin_of(s) == 0, phrase("a candidate list"));
    add(!n.has_gravity, phrase("gravity"));
    add(n.has_equal_radii && n.count > 1, phrase("a radius for each sphere"));
    add(n.has_equal_masses && n.count > 1, phrase("a mass for each sphere"));
    add(request_.scene.domain.boundary == Boundary::periodic, phrase("walls"));
  }

  static std::string number(double value) { return local_number(three_digits(value)); }
  static std::string seconds(double value) { return with_unit(value, "s", true); }

  std::string reason() const {
    const Attempt& chosen = *choice_.chosen;
    const Attempt* next = nullptr;
    for (const Attempt& attempt : choice_.tried) {
      const bool is_other = attempt.holds && attempt.method != chosen.method;
      if (is_other && (next == nullptr || attempt.cost < next->cost)) next = &attempt;
    }
    const std::string step = chosen.settings.response == Response::event_driven
                                 ? phrase("{}, which has no steps,", chosen.method)
                                 : phrase("{} with steps of {}", chosen.method, seconds(chosen.settings.dt));
    const std::string first = phrase("{} is the cheapest that holds all tolerances: {} of computing for {}", step,
                                     seconds(chosen.cost), seconds(needs().duration));
    if (!chosen.holds) return fmt::format("{} ({})", first, chosen.remark);
    return next == nullptr ? first : phrase("{}; next comes {} with {}", first, next->method, seconds(next->cost));
  }

  std::string reason_for_nothing() const {
    if (!choice_.nearest) return phrase("no method can serve; each is ruled out, or was stopped");
    const Attempt& nearest = *choice_.nearest;
    std::vector<std::string> broken;
    for (size_t k = 0; k < choice_.tolerances.size(); ++k) {
      const Tolerance& tolerance = choice_.tolerances[k];
      if (!nearest.knows(k) || nearest.errors[k] <= tolerance.allowed) continue;
      broken.push_back(
          phrase("{} {}, allowed {}", tolerance.name, number(nearest.errors[k]), number(tolerance.allowed)));
    }
    const auto out = std::ranges::find(choice_.ruled_out, nearest.method, &RuledOut::method);
    if (out != choice_.ruled_out.end()) broken.push_back(out->reason);
    if (choice_.is_out_of_time)
      broken.push_back(phrase("the budget of {} ended before all was tried", seconds(request_.budget)));
    return phrase("nothing holds all that is needed; nearest is {} with steps of {}: {}", nearest.method,
                  seconds(nearest.settings.dt), join(broken, "; "));
  }

  const ChoiceRequest& request_;
  Choice choice_;
};

}  // namespace

Choice choose(const ChoiceRequest& request) { return Chooser(request).choose(); }

std::string command_of(std::string_view name, const Scene& scene, const std::vector<GivenOption>& given,
                       const Settings& settings) {
  std::vector<GivenOption> options = options_of(settings, scene.defaults);
  for (const GivenOption& option : given) {
    const bool is_there = std::ranges::find(options, option.name, &GivenOption::name) != options.end();
    if (!is_there && option.name != "response") options.push_back(option);
  }
  return fmt::format("ballpit simulate {} {}", name, typed(options));
}

}  // namespace ballpit
