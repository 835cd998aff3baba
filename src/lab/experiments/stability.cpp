// SPDX-License-Identifier: MIT
// Maps of where methods fail: measured values as colours, and the line of the formula.
#include "lab/experiments/stability.h"

#include "lab/experiments/experiments.h"
#include "measure/theory.h"

namespace ballpit {

namespace {

constexpr double kBulletStep = 0.42;  // [m]
constexpr double kOmegaStep = 0.1;    // of an oscillator
constexpr int kPairs = 20000;         // for a single recall

int cells_of(const MapAxis& axis, bool is_quick) { return is_quick ? axis.cells : 2 * axis.cells - 1; }

std::vector<double> centres_of(const MapAxis& axis, bool is_quick) {
  return spaced(axis.low, axis.high, cells_of(axis, is_quick), axis.axis.scale);
}

/// The place of a value among evenly spaced cells: 0 in the first, 1 in the second; at most half a cell outside.
double place_among(const std::vector<double>& cells, double value, Scale scale) {
  const double last = static_cast<double>(cells.size() - 1);
  if (scale == Scale::log && value <= 0) return -0.5;
  const auto scaled = [&](double y) { return scale == Scale::log ? std::log(y) : y; };
  const double low = scaled(cells.front()), high = scaled(cells.back());
  return std::clamp((scaled(value) - low) / (high - low) * last, -0.5, last + 0.5);
}

Table table_of(const FailureMap& which, const Map& map) {
  Table table{which.name, {title_of(which.x.axis), title_of(which.y.axis), which.colors.label}};
  for (size_t column = 0; column < map.x.size(); ++column) {
    for (size_t row = 0; row < map.y.size(); ++row) {
      table.add_row(map.x[column], map.y[row], map.values[row][column]);
    }
  }
  return table;
}

Chart chart_of(const FailureMap& which, const Map& map, const MapBoundary& boundary) {
  Series theory{which.formula, "theory", {}, Stroke::line};
  for (const double x : spaced(map.x.front(), map.x.back(), 100, which.x.axis.scale)) {
    const double y = which.theory(x);
    if (y >= map.y.front() && y <= map.y.back()) theory.points.push_back({x, y});
  }
  Series measured{"", "first", {}, Stroke::points};
  for (size_t column = 0; column < map.x.size(); ++column) {
    if (!std::isnan(boundary.y[column])) measured.points.push_back({map.x[column], boundary.y[column]});
  }
  return {which.name, which.title, which.x.axis, which.y.axis, {theory, measured}, map};
}

/// Methods that are known to be wrong, and how they fail.
Table broken(Lab& lab) {
  const double recall = lab.measure_number(key_of("broken cells", kPairs, "seed", lab.seed()),
                                           [&] { return recall_of_cells(0.5, kPairs, lab.seed()); });
  const auto bullet = lab.measure(key_of("broken bullet", kBulletStep), [] {
    return std::vector<double>{double(passes_through(kBulletStep, false)), double(passes_through(kBulletStep, true))};
  });
  const double gained = lab.measure_number(key_of("broken explicit Euler", kOmegaStep),
                                           [] { return oscillator_drift("explicit-euler", kOmegaStep, 7).back(); });
  const auto yes_or_no = [](double value) { return value > 0 ? "yes" : "no"; };
  Table table{"broken", {"method", "what is seen", "measured", "theory"}, {}, true};
  table.add_row("cells of half a diameter", "recall", recall, cell_recall(0.5));
  table.add_row("contacts at the end of a step of 0.42 m", "the bullet passes through 0.2 m", yes_or_no(bullet[0]),
                "yes");
  table.add_row("swept contacts", "the bullet passes through 0.2 m", yes_or_no(bullet[1]), "no");
  table.add_row("explicit Euler, 64 steps of ωdt = 0.1", "energy gained, of that at the start", gained,
                oscillator_theory("explicit-euler", kOmegaStep, 64));
  return table;
}

int64_t measurements(bool is_quick) {
  int64_t count = 3;
  for (const FailureMap& which : failure_maps()) count += cells_of(which.x, is_quick);
  return count;
}

Findings measure(Lab& lab) {
  Findings findings;
  Table lines{"boundaries", {"map", "formula", "columns that cross", "largest distance [cells]"}, {}, true};
  double farthest = 0;
  int within = 0;  // a distance of one cell
  std::string maps;
  for (const FailureMap& which : failure_maps()) {
    const Map map = measure_map(lab, which);
    const MapBoundary boundary = boundary_of(which, map);
    farthest = std::max(farthest, boundary.distance);
    within += boundary.distance <= 1;
    lines.add_row(which.name, which.formula, boundary.columns, boundary.distance);
    findings.tables.push_back(table_of(which, map));
    findings.charts.push_back(chart_of(which, map, boundary));
    maps += phrase("{}: at the dotted line {}. ", translated(which.title), translated(which.where));
  }
  findings.tables.insert(findings.tables.end(), {lines, broken(lab)});
  findings.values = {{"descriptions", maps},
                     {"within", std::to_string(within)},
                     {"maps", std::to_string(failure_maps().size())},
                     {"farthest", three_digits(farthest)}};
  return findings;
}

}  // namespace

Map measure_map(Lab& lab, const FailureMap& which) {
  Map map{centres_of(which.x, lab.is_quick()), centres_of(which.y, lab.is_quick()), {}};
  map.values.assign(map.y.size(), std::vector<double>(map.x.size()));
  for (size_t column = 0; column < map.x.size(); ++column) {
    const double x = map.x[column];
    const auto key = key_of(which.name, x, map.y.front(), map.y.back(), map.y.size(), "seed", lab.seed());
    const auto values = lab.measure(key, [&] { return which.column(x, map.y, lab.seed()); });
    for (size_t row = 0; row < map.y.size(); ++row) map.values[row][column] = values[row];
  }
  map.colors = which.colors;
  return map;
}

MapBoundary find_boundary(const Map& map, Scale y_scale, const std::function<bool(double)>& has_crossed,
                          const std::function<double(double)>& theory) {
  MapBoundary boundary;
  const size_t rows = map.y.size();
  for (size_t column = 0; column < map.x.size(); ++column) {
    size_t row = 0;
    while (row < rows && !has_crossed(map.values[row][column])) ++row;
    const double place = static_cast<double>(row) - 0.5;
    const bool crosses = row > 0 && row < rows;
    boundary.columns += crosses;
    const double share = place / static_cast<double>(rows - 1);
    boundary.y.push_back(crosses ? between(map.y.front(), map.y.back(), share, y_scale) : kNoNumber);
    const double expected = place_among(map.y, theory(map.x[column]), y_scale);
    boundary.distance = std::max(boundary.distance, std::fabs(place - expected));
  }
  return boundary;
}

MapBoundary boundary_of(const FailureMap& which, const Map& map) {
  return find_boundary(map, which.y.axis.scale, which.has_crossed, which.theory);
}

Experiment stability_experiment() { return {"stability", 15, 150, measurements, measure}; }

}  // namespace ballpit
