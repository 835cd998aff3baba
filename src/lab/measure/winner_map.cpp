// SPDX-License-Identifier: MIT
#include "lab/measure/winner_map.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/numbers.h"
#include "lab/measure/points.h"
#include "scene/input_error.h"

namespace ballpit {

namespace {

std::vector<Settings> methods_for(double count) {
  std::vector<Settings> methods;
  for (const std::string& name : broad_phases()) {
    if (name != "brute-force" || count <= kMaxForBruteForce) methods.push_back(search_by(name));
  }
  return methods;
}

/// Timings of all broad phases, an empty one for each that was not tried.
std::vector<SearchTiming> with_gaps(const std::vector<SearchTiming>& timings, const std::vector<Settings>& methods) {
  std::vector<SearchTiming> all;
  for (const std::string& name : broad_phases()) {
    const auto found = std::find_if(methods.begin(), methods.end(),
                                    [&](const Settings& method) { return name_of(method.broadphase) == name; });
    all.push_back(found == methods.end() ? SearchTiming{} : timings[static_cast<size_t>(found - methods.begin())]);
  }
  return all;
}

double median_of(const SearchTiming& timing) { return timing.seconds.empty() ? INFINITY : timing.spread().median; }

}  // namespace

std::vector<double> winner_counts(bool is_quick) {
  if (is_quick) return {100, 300, 1000, 3000, 10'000, 30'000};
  return {100, 200, 500, 1000, 2000, 5000, 10'000, 20'000, 50'000, 100'000, 200'000, 500'000, 1'000'000};
}

int64_t winner_measurements(const WinnerPlan& plan) {
  return kSearchRounds * static_cast<int64_t>(plan.counts.size() * plan.values.size());
}

int winner_among(const std::vector<SearchTiming>& timings) {
  int best = -1, next = -1;
  for (int k = 0; k < static_cast<int>(timings.size()); ++k) {
    const auto median = [&](int m) { return m < 0 ? INFINITY : median_of(timings[static_cast<size_t>(m)]); };
    if (median(k) < median(best)) {
      next = std::exchange(best, k);
    } else if (median(k) < median(next)) {
      next = k;
    }
  }
  if (next < 0) return best;
  const std::vector<double>&first = timings[static_cast<size_t>(best)].seconds,
        &second = timings[static_cast<size_t>(next)].seconds;
  size_t won = 0;
  for (size_t turn = 0; turn < first.size(); ++turn) won += first[turn] < second[turn];
  return 9 * won >= 8 * first.size() ? best : kTie;
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
    cells[c].timings = with_gaps(timings[c], cases[c].methods);
    cells[c].winner = winner_among(cells[c].timings);
  }
  return cells;
}

Chart winner_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells, const std::string& title) {
  Map map{plan.counts, plan.values, {}, {}};
  for (const std::string& name : broad_phases()) map.categories.push_back({label_of(name), name});
  const auto tie = static_cast<double>(map.categories.size());
  map.categories.push_back({"too close to tell", "theory"});
  map.values.assign(plan.values.size(), std::vector<double>(plan.counts.size(), kNoNumber));
  for (const WinnerCell& cell : cells) {
    const auto row = std::find(plan.values.begin(), plan.values.end(), cell.value) - plan.values.begin();
    const auto column = std::find(plan.counts.begin(), plan.counts.end(), cell.count) - plan.counts.begin();
    map.values[static_cast<size_t>(row)][static_cast<size_t>(column)] = cell.winner == kTie ? tie : cell.winner;
  }
  return {"winner", title, Axis{"spheres", "", Scale::log}, plan.axis, {}, std::move(map)};
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

Chart time_chart(const WinnerPlan& plan, const std::vector<WinnerCell>& cells) {
  return {"time", fmt::format("Time of a search, {} spheres", grouped(static_cast<int64_t>(plan.counts.back()))),
          plan.axis, Axis{"time of a search", "ms", Scale::log},
          series_of(plan, cells, [](const WinnerCell& cell, const SearchTiming& timing) {
            return point_of(cell.value, timing.spread(), 1e3);
          })};
}

Table winner_table(const WinnerPlan& plan, const std::vector<WinnerCell>& cells) {
  Table table{"searches", {"spheres", title_of(plan.axis), "fastest"}};
  for (const std::string& name : broad_phases()) {
    for (const char* column :
         {"time by {} [ms]", "lower quartile by {} [ms]", "upper quartile by {} [ms]", "candidates by {}"}) {
      table.columns.push_back(fmt::format(fmt::runtime(column), name));
    }
  }
  for (const WinnerCell& cell : cells) {
    const std::string fastest =
        cell.winner == kTie ? "too close to tell" : broad_phases()[static_cast<size_t>(cell.winner)];
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

std::string tally_of(const std::vector<WinnerCell>& cells) {
  const auto count = [&](int winner) {
    return std::count_if(cells.begin(), cells.end(), [&](const WinnerCell& cell) { return cell.winner == winner; });
  };
  std::vector<std::pair<std::ptrdiff_t, std::string>> wins;
  for (size_t k = 0; k < broad_phases().size(); ++k) {
    const std::ptrdiff_t number = count(static_cast<int>(k));
    if (number > 0) wins.emplace_back(number, label_of(broad_phases()[k]));
  }
  std::sort(wins.rbegin(), wins.rend());
  std::string text;
  for (const auto& [number, name] : wins) {
    text += text.empty() ? fmt::format("{} is fastest in {} of {} cases", name, number, cells.size())
                         : fmt::format(", {} in {}", name, number);
  }
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (const auto ties = count(kTie); ties > 0) {
    text += fmt::format(", and {} {} too close to tell", ties, ties == 1 ? "is" : "are");
  }
  return text;
}

std::string winning_rule() {
  return "Times are of searches from bare arrays to the list of pairs, on one thread: medians of nine turns "
         "in three rounds. A cell of the map shows the fastest method, unless the second is faster in more "
         "than one turn of nine: such cells are grey. Brute force was not tried with more than 30 000 "
         "spheres, where it needs half a billion tests.";
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
