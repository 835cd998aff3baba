// SPDX-License-Identifier: MIT
// Is what `choose` picks good enough, and how much dearer is it than it had to be? Random scenes (lab/measure/held_out.h)
// are judged one by one: the choice runs in full against the needs of its scene, and its cost is divided by that of the
// cheapest valid option of a wide grid (lab/measure/regret.h).
//
//     regret  │            ·   at most 4
//             │          ··          the scenes in order of their regret
//          1  │··········            1: nothing in the grid is cheaper
//             └────────────
//
// A scene takes three seconds, up to a minute where the grid is dear.
#include "lab/experiments/choice.h"

#include <array>
#include <map>
#include <optional>
#include <tuple>

#include "lab/experiments/experiments.h"
#include "lab/measure/held_out.h"
#include "scene/read_scene.h"

namespace ballpit {

namespace {

constexpr double kMedianBound = 1.5, kWorstBound = 4;  // regrets that are good enough
constexpr double kBudget = 5;                          // [s] for a choice: the default of `choose`

struct FamilyLook {
  const char *label, *role;
};

/// In the order of kHeldOutFamilies.
constexpr std::array<FamilyLook, kHeldOutFamilies.size()> kLooks{{{"gases", "first"},
                                                                  {"heaps", "second"},
                                                                  {"stacks", "third"},
                                                                  {"cradles", "fourth"},
                                                                  {"bullets", "fifth"},
                                                                  {"mixtures", "sixth"},
                                                                  {"planar", "seventh"}}};

int64_t measurements(bool is_quick) { return is_quick ? std::ssize(kHeldOutFamilies) : 200; }

/// A name as a number, for the cache.
double index_in(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<double>(std::ranges::find(names, name) - names.begin());
}

std::string name_at(const std::vector<std::string>& names, double index) {
  return index < static_cast<double>(names.size()) ? names[static_cast<size_t>(index)] : "";
}

JudgedScene judge_one(Lab& lab, uint64_t seed) {
  const std::vector<std::string> names = judged_methods();
  const HeldOutScene held_out = held_out_scene(seed, drawn_units(seed));
  const auto values = lab.time(key_of("choice", seed, kBudget, names.size()), [&] {
    const Judged j = judge(held_out.family, parse_scene(held_out.text, "held-out.toml"), kBudget);
    return std::vector<double>{static_cast<double>(j.count),
                               static_cast<double>(j.has_choice),
                               static_cast<double>(j.has_valid),
                               static_cast<double>(j.holds),
                               j.cost,
                               j.best_cost,
                               index_in(names, j.method),
                               index_in(names, j.best_method),
                               j.chosen_in};
  });
  Judged judged{.family = std::string(held_out.family), .count = std::llround(values.at(0))};
  judged.has_choice = values.at(1) != 0;
  judged.has_valid = values.at(2) != 0;
  judged.holds = values.at(3) != 0;
  judged.cost = values.at(4);
  judged.best_cost = values.at(5);
  judged.method = name_at(names, values.at(6));
  judged.best_method = name_at(names, values.at(7));
  judged.chosen_in = values.at(8);
  return {seed, judged};
}

std::vector<JudgedScene> judge_all(Lab& lab) {
  std::vector<JudgedScene> all;
  const uint64_t first = 1000 * lab.seed();
  for (int64_t k = 0; k < measurements(lab.is_quick()); ++k) {
    all.push_back(judge_one(lab, first + static_cast<uint64_t>(k)));
  }
  return all;
}

std::vector<double> regrets_of(const std::vector<JudgedScene>& all) {
  std::vector<double> regrets;
  for (const JudgedScene& scene : all) {
    if (scene.has_regret()) regrets.push_back(scene.judged.regret());
  }
  return regrets;
}

double median_of(const std::vector<double>& values) { return values.empty() ? kNoNumber : spread_of(values).median; }
double worst_of(const std::vector<double>& values) {
  return values.empty() ? kNoNumber : *std::ranges::max_element(values);
}

/// Points of each family, whose labels are listed beside the plot. `to_point` gives nothing where there is none.
template <class ToPoint>
void add_families(Chart& chart, const std::vector<JudgedScene>& all, const ToPoint& to_point) {
  chart.lists_points = true;
  for (size_t k = 0; k < kHeldOutFamilies.size(); ++k) {
    Series series{kLooks[k].label, kLooks[k].role, {}, Stroke::points};
    series.is_thin = all.size() > 50;
    for (const JudgedScene& scene : all) {
      if (scene.judged.family != kHeldOutFamilies[k]) continue;
      if (const std::optional<Point> point = to_point(scene)) series.points.push_back(*point);
    }
    chart.series.push_back(std::move(series));
  }
}

/// A dotted line across the chart whose label stands on its left part, where the regrets are low.
void add_limit(Chart& chart, const std::string& label, double regret) {
  const auto y = [&](double) { return regret; };
  chart.series.push_back(theory_line("", {0, 100}, y));
  chart.series.push_back(theory_line("\u00A0" + translated(label), {0, 3}, y));
}

/// The scenes in order of their regret. Broken choices and what was not found stand at the end, as failed.
Chart regret_chart(const std::vector<JudgedScene>& all) {
  std::vector<JudgedScene> sorted;
  for (const JudgedScene& scene : all) {
    if (scene.judged.has_choice || scene.is_missed()) sorted.push_back(scene);
  }
  const auto height = [](const JudgedScene& scene) { return scene.has_regret() ? scene.judged.regret() : INFINITY; };
  const auto family = [](const JudgedScene& scene) { return std::ranges::find(kHeldOutFamilies, scene.judged.family); };
  std::ranges::sort(sorted, {}, [&](const JudgedScene& s) { return std::tuple(height(s), family(s), s.seed); });

  const double worst = worst_of(regrets_of(all));
  Chart chart{"regret", "How much dearer the choice is than the cheapest that holds",
              Axis{"scenes, by their regret", "%", Scale::linear, 0, 100},
              Axis{"regret: cost / least cost", "", Scale::log, 0.93, std::max(1.3 * kWorstBound, 1.1 * worst)}};
  add_limit(chart, "worst: at most 4", kWorstBound);
  add_limit(chart, "median: at most 1.5", kMedianBound);
  const auto place = [&](size_t k) {
    return 100 * (static_cast<double>(k) + 0.5) / static_cast<double>(sorted.size());
  };
  std::map<uint64_t, double> places;
  for (size_t k = 0; k < sorted.size(); ++k) places[sorted[k].seed] = place(k);
  add_families(chart, sorted, [&](const JudgedScene& scene) -> std::optional<Point> {
    return Point{places[scene.seed], height(scene)};
  });
  return chart;
}

/// The costs of both, those below kEqualCosts as that.
Chart cost_chart(const std::vector<JudgedScene>& all) {
  const auto milliseconds = [](double cost) { return 1e3 * std::max(cost, kEqualCosts); };
  double high = 0;  // [ms]
  for (const JudgedScene& scene : all) {
    high = std::max({high, milliseconds(scene.judged.cost), milliseconds(scene.judged.best_cost)});
  }
  const double low = milliseconds(0) / 1.3, end = 1.5 * high;
  Chart chart{"cost", "Cost of the choice against that of the cheapest", Axis{"least cost", "ms", Scale::log, low, end},
              Axis{"cost of the choice", "ms", Scale::log, low, 1.2 * kWorstBound * end}};
  chart.series.push_back(theory_line("as cheap", {low, end}, [](double x) { return x; }));
  chart.series.push_back(theory_line("4 times as dear", {low, end}, [](double x) { return kWorstBound * x; }));
  add_families(chart, all, [&](const JudgedScene& scene) -> std::optional<Point> {
    const Judged& j = scene.judged;
    if (!j.has_choice || !j.has_valid) return {};
    return Point{milliseconds(j.best_cost), j.holds ? milliseconds(j.cost) : INFINITY};
  });
  return chart;
}

Table table_of(const std::vector<JudgedScene>& all) {
  Table table{"scenes",
              {"seed", "family", "spheres", "holds", "regret", "cost [s]", "cheapest [s]", "method", "cheapest method",
               "time of the choice [s]"}};
  for (const JudgedScene& scene : all) {
    const Judged& j = scene.judged;
    table.add_row(static_cast<double>(scene.seed), j.family, j.count,
                  scene.is_refused() ? "refused"
                  : j.holds          ? "yes"
                                     : "no",
                  scene.has_regret() ? j.regret() : kNoNumber, j.cost, j.best_cost, j.method, j.best_method,
                  j.chosen_in);
  }
  return table;
}

Table summary_of(const std::vector<JudgedScene>& all) {
  Table table{"families",
              {"family", "scenes", "broken", "refused", "of these, something holds", "median regret", "worst regret",
               "median time of a choice [s]"}};
  table.is_shown = true;
  const auto add = [&](std::string_view name, const auto& is_of) {
    std::vector<JudgedScene> part;
    std::ranges::copy_if(all, std::back_inserter(part), is_of);
    if (part.empty()) return;
    std::vector<double> times;
    for (const JudgedScene& scene : part) times.push_back(scene.judged.chosen_in);
    const std::vector<double> regrets = regrets_of(part);
    table.add_row(name, part.size(), std::ranges::count_if(part, &JudgedScene::is_broken),
                  std::ranges::count_if(part, &JudgedScene::is_refused),
                  std::ranges::count_if(part, &JudgedScene::is_missed), median_of(regrets), worst_of(regrets),
                  median_of(times));
  };
  for (size_t k = 0; k < kHeldOutFamilies.size(); ++k) {
    add(kLooks[k].label, [&](const JudgedScene& scene) { return scene.judged.family == kHeldOutFamilies[k]; });
  }
  add("all", [](const JudgedScene&) { return true; });
  return table;
}

/// "no tolerance was broken", or in how many scenes one was; and where something holds that was not found.
std::string failures_of(const std::vector<JudgedScene>& all) {
  const auto broken = std::ranges::count_if(all, &JudgedScene::is_broken);
  const auto missed = std::ranges::count_if(all, &JudgedScene::is_missed);
  std::string text = broken == 0   ? translated("no tolerance was broken")
                     : broken == 1 ? translated("1 choice broke a tolerance")
                                   : phrase("{} choices broke a tolerance", broken);
  if (missed > 0) text += phrase(", in {} nothing was found although something holds", missed);
  return text;
}

Findings measure(Lab& lab) { return choice_findings(judge_all(lab)); }

}  // namespace

Findings choice_findings(const std::vector<JudgedScene>& all) {
  const std::vector<double> regrets = regrets_of(all);
  return {{summary_of(all), table_of(all)},
          {regret_chart(all), cost_chart(all)},
          {{"n", std::to_string(all.size())},
           {"failures", failures_of(all)},
           {"median", regrets.empty() ? "–" : three_digits(median_of(regrets))},
           {"worst", regrets.empty() ? "–" : three_digits(worst_of(regrets))},
           {"equal", number_text(1e3 * kEqualCosts)}}};
}

Experiment choice_experiment() { return {"choice", 20, 900, measurements, measure}; }

}  // namespace ballpit
