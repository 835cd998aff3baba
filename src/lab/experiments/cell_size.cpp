// SPDX-License-Identifier: MIT
// Slide 7: the size of the cells determines the run time, and cells that are too small miss contacts. Time and recall
// against the edge of the cells, with the bound on slide 7 (r) and the one from which nothing is missed (2·r_max).
//
//     c = 1      c = .5          A search tests two spheres if their cells are neighbours: along each axis, the indices
//    ┌───┬───┐  ┌─┬─┬─┬─┐        differ by one at most. For centres at a distance d along it this is certain if d ≤ c
//    │ ● │ ● │  │●│ │ │●│        and impossible if d > 2·c. Between, it has the probability 2 − d/c, since the grid has
//    └───┴───┘  └─┴─┴─┴─┘        a random place.
#include <cassert>

#include "lab/experiments/experiments.h"
#include "lab/measure/searches.h"
#include "measure/exact_pairs.h"
#include "world/world.h"

namespace ballpit {

namespace {

const std::vector<std::string> kGrids{"linked-cell", "sorted-grid"};

/// In units of 2·r_max.
std::vector<double> cell_sizes(bool is_quick) {
  if (is_quick) return {0.25, 0.35, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.4, 2, 2.8, 4, 5.6, 8};
  std::vector<double> sizes;
  for (int k = -10; k <= 15; ++k) sizes.push_back(std::round(1000 * std::exp2(k / 5.0)) / 1000);
  return sizes;
}

int64_t count_of(bool is_quick) { return is_quick ? 10'000 : 100'000; }

Settings with_cells(const std::string& grid, double size) {
  Settings settings = search_by(grid);
  settings.cell_size = size;
  return settings;
}

/// For pairs that touch: the share that each grid finds, the share by the formula, its error.
std::vector<double> measure_recall(int64_t count, double size, uint64_t seed) {
  const SphereSet spheres = touching_pairs(count, seed);
  const std::vector<Pair> contacts = exact_pairs(spheres.arrays());
  std::vector<double> values;
  for (const std::string& grid : kGrids) {
    const auto search = cpu_backend().make_pair_search(with_cells(grid, size));
    search->find(spheres.arrays());
    const Deviation deviation = deviation_of(search->pairs(), contacts);
    values.push_back(1 - static_cast<double>(deviation.missed) / static_cast<double>(contacts.size()));
  }
  const double expected = expected_recall(spheres, contacts, size);
  values.insert(values.end(), {expected, recall_error(expected, contacts.size())});
  return values;
}

const std::vector<Bound> kBounds{{0.5, "slide 7: r"}, {1, "2·r_max"}};
const Axis kCells{"edge of a cell", "2·r_max", Scale::log};

struct Row {
  double size;
  std::vector<double> recall;         ///< of each grid, then expected, then its error
  std::vector<SearchTiming> timings;  ///< of each grid
};

std::vector<Row> measure_all(Lab& lab) {
  const int64_t count = count_of(lab.is_quick());
  std::vector<Row> rows;
  std::vector<SearchCase> cases;
  for (const double size : cell_sizes(lab.is_quick())) {
    const std::string key = fmt::format("cells {}; {} spheres; seed {}", number_text(size), count, lab.seed());
    rows.push_back({size, lab.measure("recall; " + key, [&] { return measure_recall(count, size, lab.seed()); }), {}});
    std::vector<Settings> methods;
    for (const std::string& grid : kGrids) methods.push_back(with_cells(grid, size));
    cases.push_back({"time; " + key, methods, [&] { return uniform_spheres({count}, lab.seed()); }});
  }
  const std::vector<std::vector<SearchTiming>> timings = time_searches(lab, cases);
  for (size_t k = 0; k < rows.size(); ++k) rows[k].timings = timings[k];
  return rows;
}

/// A chart against the cells' edge, with a series for each grid.
template <class ToPoint>
Chart chart_of(const char* name, const std::string& title, const Axis& y, const std::vector<Row>& rows, Stroke stroke,
               const ToPoint& to_point) {
  Chart chart{name, title, kCells, y, {}, {}, kBounds};
  for (size_t k = 0; k < kGrids.size(); ++k) {
    chart.series.push_back(
        make_series(label_of(kGrids[k]), kGrids[k], stroke, rows, [&](const Row& row) { return to_point(row, k); }));
  }
  return chart;
}

Chart time_chart(const std::vector<Row>& rows, int64_t count) {
  return chart_of("time", phrase("Time of a search against cell size, {} spheres", grouped(count)),
                  {"time of a search", "ms", Scale::log}, rows, Stroke::line_and_points,
                  [](const Row& row, size_t k) { return point_of(row.size, row.timings[k].spread(), 1e3); });
}

Chart recall_chart(const std::vector<Row>& rows) {
  Chart chart = chart_of("recall", "Contacts found against cell size", {"contacts found", "%"}, rows, Stroke::points,
                         [](const Row& row, size_t k) {
                           return point_of(row.size, Mean{100 * row.recall[k], 100 * row.recall[3]});
                         });
  chart.x.high = 8.5;
  const auto expected = [](const Row& row) { return Point{row.size, 100 * row.recall[2]}; };
  chart.series.insert(chart.series.begin(), make_series("formula", "theory", Stroke::line, rows, expected));
  return chart;
}

Table table_of(const std::vector<Row>& rows) {
  Table table{"cells", {"edge of a cell [2·r_max]", "recall expected", "standard error"}};
  for (const std::string& grid : kGrids) {
    table.add_columns({"recall by {}", "candidates by {}", "time by {} [ms]", "lower quartile by {} [ms]",
                       "upper quartile by {} [ms]"},
                      grid);
  }
  for (const Row& row : rows) {
    std::vector<Cell> cells{row.size, row.recall[2], row.recall[3]};
    for (size_t k = 0; k < kGrids.size(); ++k) {
      const Spread spread = row.timings[k].spread();
      cells.insert(cells.end(), {row.recall[k], row.timings[k].candidates, 1e3 * spread.median, 1e3 * spread.lower,
                                 1e3 * spread.upper});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// The fastest cell size of linked cells among those that miss nothing.
const Row& fastest(const std::vector<Row>& rows) {
  const Row* best = &rows.back();
  for (const Row& row : rows) {
    if (row.size >= 1 && row.timings[0].spread().median < best->timings[0].spread().median) best = &row;
  }
  return *best;
}

int64_t measurements(bool is_quick) { return (1 + kSearchRounds) * static_cast<int64_t>(cell_sizes(is_quick).size()); }

Findings measure(Lab& lab) {
  const std::vector<Row> rows = measure_all(lab);
  const Row& half = *std::ranges::find(rows, 0.5, &Row::size);
  const Row& best = fastest(rows);
  const double slowdown = rows.back().timings[0].spread().median / best.timings[0].spread().median;
  return {{table_of(rows)},
          {recall_chart(rows), time_chart(rows, count_of(lab.is_quick()))},
          {{"found", three_digits(100 * half.recall[0])},
           {"expected", three_digits(100 * half.recall[2])},
           {"best", number_text(best.size)},
           {"slowdown", three_digits(slowdown)}}};
}

}  // namespace

double expected_recall(const SphereSet& spheres, const std::vector<Pair>& contacts, double edge) {
  assert(!contacts.empty());
  double sum = 0;
  for (const Pair& pair : contacts) {
    const Vec3d apart =
        Vec3d(spheres.position[static_cast<size_t>(pair.j)]) - Vec3d(spheres.position[static_cast<size_t>(pair.i)]);
    double share = 1;
    for (int axis = 0; axis < 3; ++axis) share *= std::clamp(2 - std::abs(apart[axis]) / edge, 0.0, 1.0);
    sum += share;
  }
  return sum / static_cast<double>(contacts.size());
}

double recall_error(double recall, size_t contacts) {
  return std::sqrt(recall * (1 - recall) / static_cast<double>(contacts));
}

Experiment cell_size_experiment() { return {"cell-size", 6, 110, measurements, measure}; }

}  // namespace ballpit
