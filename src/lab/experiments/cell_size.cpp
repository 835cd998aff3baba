// SPDX-License-Identifier: MIT
// Slide 7: cell size drives the run time, and cells that are too small let contacts fall through. Time and recall against
// the cells' edge, with the bound that slide 7 prints (r) and the one that makes the block complete (2·r_max).
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "core/numbers.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/recall.h"
#include "lab/measure/search_timing.h"
#include "measure/exact_pairs.h"
#include "scene/input_error.h"
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

struct Recall {
  double found, expected, error;
};

/// Of pairs that touch: share found by each grid, the formula's share, its error.
std::vector<double> measure_recall(int64_t count, double size, uint64_t seed) {
  const SphereSet spheres = touching_pairs(count, seed);
  const std::vector<Pair> contacts = exact_pairs(spheres.arrays());
  std::vector<double> values;
  for (const std::string& grid : kGrids) {
    const std::unique_ptr<PairSearch> search = cpu_backend().make_pair_search(with_cells(grid, size));
    search->find(spheres.arrays());
    const Deviation deviation = deviation_of(search->pairs(), contacts);
    values.push_back(1 - static_cast<double>(deviation.missed) / static_cast<double>(contacts.size()));
  }
  const double expected = expected_recall(spheres, contacts, size);
  values.insert(values.end(), {expected, recall_error(expected, contacts.size())});
  return values;
}

const std::vector<Bound>& bounds() {
  static const std::vector<Bound> both{{0.5, "slide 7: r"}, {1, "2·r_max"}};
  return both;
}

Axis cells_axis() { return {"edge of a cell", "2·r_max", Scale::log}; }

struct Row {
  double size;
  std::vector<double> recall;         ///< of each grid, then expected, then its error
  std::vector<SearchTiming> timings;  ///< of each grid
};

std::vector<Row> measure_all(Lab& lab) {
  const int64_t count = count_of(lab.is_quick());
  const std::string spheres = std::to_string(count) + " spheres; seed " + std::to_string(lab.seed());
  std::vector<Row> rows;
  std::vector<SearchCase> cases;
  for (const double size : cell_sizes(lab.is_quick())) {
    const std::string cells = "cells " + number_text(size);
    rows.push_back(
        {size,
         lab.measure("recall; " + cells + "; " + spheres, [&] { return measure_recall(count, size, lab.seed()); }),
         {}});
    std::vector<Settings> ways;
    for (const std::string& grid : kGrids) ways.push_back(with_cells(grid, size));
    cases.push_back({"time; " + cells + "; " + spheres, ways, [&] { return uniform_spheres({count}, lab.seed()); }});
  }
  const std::vector<std::vector<SearchTiming>> timings = time_searches(lab, cases);
  for (size_t k = 0; k < rows.size(); ++k) rows[k].timings = timings[k];
  return rows;
}

Chart time_chart(const std::vector<Row>& rows, int64_t count) {
  Chart chart{"time",       "Time of a search against cell size, " + grouped(count) + " spheres",
              cells_axis(), {"time of a search", "ms", Scale::log},
              {},           {},
              bounds()};
  for (size_t k = 0; k < kGrids.size(); ++k) {
    Series series{label_of(kGrids[k]), kGrids[k], {}};
    for (const Row& row : rows) {
      const Spread spread = row.timings[k].spread();
      series.points.push_back({row.size, 1e3 * spread.median, 1e3 * spread.lower, 1e3 * spread.upper});
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

Chart recall_chart(const std::vector<Row>& rows) {
  Chart chart{"recall", "Contacts found against cell size", cells_axis(), {"contacts found", "%"}, {}, {}, bounds()};
  chart.x.high = 8.5;
  Series theory{"formula", "theory", {}, Stroke::line};
  for (const Row& row : rows) theory.points.push_back({row.size, 100 * row.recall[2]});
  chart.series.push_back(std::move(theory));
  for (size_t k = 0; k < kGrids.size(); ++k) {
    Series series{label_of(kGrids[k]), kGrids[k], {}, Stroke::points};
    for (const Row& row : rows) {
      const double found = 100 * row.recall[k], error = 100 * row.recall[3];
      series.points.push_back({row.size, found, found - error, found + error});
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

Table table_of(const std::vector<Row>& rows) {
  Table table{"cells", {{"edge of a cell", "2·r_max"}, {"recall expected"}, {"standard error"}}, {}};
  for (const std::string& grid : kGrids) {
    for (const Column& column : {Column{"recall by "}, Column{"candidates by "}, Column{"time by ", "ms"},
                                 Column{"lower quartile by ", "ms"}, Column{"upper quartile by ", "ms"}}) {
      table.columns.push_back({column.name + grid, column.unit});
    }
  }
  for (const Row& row : rows) {
    std::vector<Cell> cells{row.size, row.recall[2], row.recall[3]};
    for (size_t k = 0; k < kGrids.size(); ++k) {
      const Spread spread = row.timings[k].spread();
      for (const double value :
           {row.recall[k], row.timings[k].candidates, 1e3 * spread.median, 1e3 * spread.lower, 1e3 * spread.upper}) {
        cells.emplace_back(value);
      }
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

const Row& row_at(const std::vector<Row>& rows, double size) {
  return *std::min_element(rows.begin(), rows.end(), [&](const Row& a, const Row& b) {
    return std::fabs(a.size - size) < std::fabs(b.size - size);
  });
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

Findings run(Lab& lab) {
  const std::vector<Row> rows = measure_all(lab);
  const Row& half = row_at(rows, 0.5);
  const Row& best = fastest(rows);
  const double slowdown = rows.back().timings[0].spread().median / best.timings[0].spread().median;
  Findings findings;
  findings.tables = {table_of(rows)};
  findings.charts = {recall_chart(rows), time_chart(rows, count_of(lab.is_quick()))};
  findings.answer = "Cells as wide as slide 7 allows at least, r, find only " + three_digits(100 * half.recall[0]) +
                    " % of the contacts of touching spheres (theory: " + three_digits(100 * half.recall[2]) +
                    " %). From 2·r_max on nothing is missed; there, linked cells are fastest at " +
                    number_text(best.size) + " times 2·r_max, " + three_digits(slowdown) + " times as fast as at 8.";
  findings.see =
      "First, the share of contacts that the 3 × 3 × 3 block finds among pairs of equal spheres that just touch, in "
      "random directions, against an exact reference; dotted, the formula: along each axis two centres a distance d "
      "apart lie in neighbouring cells of edge c with probability 2 − d/c, and no more than 1; bars are one standard "
      "error. Slide 7 prints the least radius as its bound, half of what the block needs: between r and 2·r_max real "
      "contacts fall through. Second, the time of a search on one thread among spheres that fill 30 % of the box: "
      "smaller cells mean more cells to visit, larger ones more spheres in each, and candidates grow as the cube of "
      "the edge. Without --cell-size both grids choose cells that miss nothing; the sorted grid then looks only as "
      "far as spheres reach, and is faster than here.";
  return findings;
}

}  // namespace

Experiment cell_size_experiment() {
  return {"cell-size",
          "Cell size: time and recall",
          "How large should a cell be, and what falls through when it is too small?",
          6,
          110,
          measurements,
          run};
}

}  // namespace ballpit
