// SPDX-License-Identifier: MIT
#include "lab/experiments/winner_map.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

#include "lab/experiments/experiments.h"

namespace ballpit {

namespace {

constexpr const char* kTieName = "too close to tell";
constexpr double kMaxForBruteForce = 30'000;  // it makes n²/2 tests, and is slowest long before

std::vector<Settings> methods_for(double count) {
  std::vector<Settings> methods;
  for (const std::string& name : broad_phases()) {
    if (name != "brute-force" || count <= kMaxForBruteForce) methods.push_back(search_by(name));
  }
  return methods;
}

double median_of(const SearchTiming& timing) { return timing.seconds.empty() ? INFINITY : timing.spread().median; }

Chart winner_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells) {
  Map map{plan.counts, plan.values, {}, {}};
  for (const std::string& name : broad_phases()) map.categories.push_back({label_of(name), name});
  map.categories.push_back({kTieName, "theory"});
  map.values.assign(plan.values.size(), std::vector<double>(plan.counts.size()));
  for (size_t k = 0; k < cells.size(); ++k) {  // in the order of find_winners()
    const auto category = cells[k].winner == kTie ? broad_phases().size() : static_cast<size_t>(cells[k].winner);
    map.values[k % plan.values.size()][k / plan.values.size()] = static_cast<double>(category);
  }
  return {"winner", plan.title, Axis{"spheres", "", Scale::log}, plan.axis, {}, std::move(map)};
}

Chart time_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells) {
  return {"time", phrase("Time of a search, {} spheres", grouped(static_cast<int64_t>(plan.counts.back()))), plan.axis,
          Axis{"time of a search", "ms", Scale::log},
          series_of(plan, cells, [](const WinnerCell& cell, const SearchTiming& timing) {
            return point_of(cell.value, timing.spread(), 1e3);
          })};
}

Table winner_table(const WinnerPlan& plan, const std::vector<WinnerCell>& cells) {
  Table table{"searches", {"spheres", title_of(plan.axis), "fastest"}};
  for (const std::string& name : broad_phases()) {
    table.add_columns({"time by {} [ms]", "lower quartile by {} [ms]", "upper quartile by {} [ms]", "candidates by {}"},
                      name);
  }
  for (const WinnerCell& cell : cells) {
    const std::string fastest = cell.winner == kTie ? kTieName : broad_phases()[static_cast<size_t>(cell.winner)];
    std::vector<Cell> row{cell.count, cell.value, fastest};
    for (const SearchTiming& timing : cell.timings) {
      if (timing.seconds.empty()) {
        row.insert(row.end(), 4, kNoNumber);
        continue;
      }
      const Spread spread = timing.spread();
      row.insert(row.end(), {1e3 * spread.median, 1e3 * spread.lower, 1e3 * spread.upper, timing.candidates});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// "Sorted grid is fastest in 20 of 30 cases, linked cell in 5, and 5 are too close to tell"
std::string tally_of(const std::vector<WinnerCell>& cells) {
  std::vector<std::pair<std::ptrdiff_t, std::string>> wins;
  for (int k = 0; k < static_cast<int>(broad_phases().size()); ++k) {
    const std::ptrdiff_t number = std::ranges::count(cells, k, &WinnerCell::winner);
    if (number > 0) wins.emplace_back(number, translated(label_of(broad_phases()[static_cast<size_t>(k)])));
  }
  std::sort(wins.rbegin(), wins.rend());
  std::string text;
  for (const auto& [number, name] : wins) {
    text += text.empty() ? phrase("{} is fastest in {} of {} cases", name, number, cells.size())
                         : phrase(", {} in {}", name, number);
  }
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  const std::ptrdiff_t ties = std::ranges::count(cells, kTie, &WinnerCell::winner);
  if (ties == 0) return text;
  return text +
         (ties == 1 ? translated(", and 1 is too close to tell") : phrase(", and {} are too close to tell", ties));
}

}  // namespace

std::vector<double> winner_counts(bool is_quick) {
  if (is_quick) return {100, 300, 1000, 3000, 10'000, 30'000};
  return {100, 200, 500, 1000, 2000, 5000, 10'000, 20'000, 50'000, 100'000, 200'000, 500'000, 1'000'000};
}

int64_t winner_measurements(const WinnerPlan& plan) {
  return kSearchRounds * static_cast<int64_t>(plan.counts.size() * plan.values.size());
}

int winner_among(const std::vector<SearchTiming>& timings) {
  std::vector<int> order(timings.size());
  std::iota(order.begin(), order.end(), 0);
  const auto timing = [&](int k) -> const SearchTiming& { return timings[static_cast<size_t>(k)]; };
  std::ranges::stable_sort(order, {}, [&](int k) { return median_of(timing(k)); });
  const std::vector<double>&first = timing(order[0]).seconds, &second = timing(order[1]).seconds;
  if (second.empty()) return order[0];
  size_t won = 0;
  for (size_t turn = 0; turn < first.size(); ++turn) won += first[turn] < second[turn];
  return 9 * won >= 8 * first.size() ? order[0] : kTie;
}

std::vector<WinnerCell> find_winners(Lab& lab, const WinnerPlan& plan) {
  std::vector<SearchCase> cases;
  std::vector<WinnerCell> cells;
  for (const double count : plan.counts) {
    for (const double value : plan.values) {
      cases.push_back({fmt::format("search by all broad phases; {} spheres; {} {}; seed {}", number_text(count),
                                   plan.parameter, number_text(value), lab.seed()),
                       methods_for(count), [&, count, value] {
                         return plan.make_spheres(static_cast<int64_t>(count), value, lab.seed());
                       }});
      cells.push_back({count, value, {}, kTie});
    }
  }
  const std::vector<std::vector<SearchTiming>> timings = time_searches(lab, cases);
  for (size_t c = 0; c < cells.size(); ++c) {
    cells[c].timings = timings[c];
    const size_t missing = broad_phases().size() - timings[c].size();  // brute force, which is the first
    cells[c].timings.insert(cells[c].timings.begin(), missing, SearchTiming{});
    cells[c].winner = winner_among(cells[c].timings);
  }
  return cells;
}

std::vector<Series> series_of(const WinnerPlan& plan, const std::vector<WinnerCell>& cells,
                              const std::function<Point(const WinnerCell&, const SearchTiming&)>& to_point) {
  std::vector<Series> all;
  for (size_t k = 0; k < broad_phases().size(); ++k) {
    Series series{label_of(broad_phases()[k]), broad_phases()[k]};
    for (const WinnerCell& cell : cells) {
      if (cell.count != plan.counts.back() || cell.timings[k].seconds.empty()) continue;
      series.points.push_back(to_point(cell, cell.timings[k]));
    }
    if (!series.points.empty()) all.push_back(std::move(series));
  }
  return all;
}

Findings winner_findings(const WinnerPlan& plan, const std::vector<WinnerCell>& cells) {
  return {{winner_table(plan, cells)},
          {winner_chart(plan, cells), time_chart(plan, cells)},
          {{"wins", tally_of(cells)}, {"rule", paragraphs_of("winning-rule").front()}}};
}

double median_of(const WinnerCell& cell, std::string_view broad_phase) {
  const auto method = std::ranges::find(broad_phases(), broad_phase) - broad_phases().begin();
  return median_of(cell.timings[static_cast<size_t>(method)]);
}

std::vector<double> worst_losses(const std::vector<WinnerCell>& cells) {
  std::vector<double> worst(broad_phases().size(), 1);
  for (const WinnerCell& cell : cells) {
    double best = INFINITY;
    for (const SearchTiming& timing : cell.timings) best = std::min(best, median_of(timing));
    for (size_t k = 0; k < worst.size(); ++k) {
      const double median = median_of(cell.timings[k]);
      if (std::isfinite(median)) worst[k] = std::max(worst[k], median / best);
    }
  }
  return worst;
}

}  // namespace ballpit
