// SPDX-License-Identifier: MIT
// The boundary of a map, and its distance from theory.
#include <cmath>

#include <catch2/catch.hpp>

#include "lab/charts/chart.h"
#include "lab/experiments/stability.h"

using namespace ballpit;

namespace {

/// 1 in cells above the line y = x, else 0; 5 × 5 cells of centres 1 … 5.
Map diagonal() {
  Map map{spaced(1, 5, 5, Scale::linear), spaced(1, 5, 5, Scale::linear), {}};
  for (const double y : map.y) {
    map.values.emplace_back();
    for (const double x : map.x) map.values.back().push_back(y > x ? 1.0 : 0.0);
  }
  return map;
}

bool is_one(double value) { return value > 0.5; }

}  // namespace

TEST_CASE("a boundary lies half way between the cells that differ, and half a cell from a line through a centre") {
  const MapBoundary boundary = find_boundary(diagonal(), Scale::linear, is_one, [](double x) { return x; });
  CHECK(boundary.columns == 4);  // the last has nothing above the line
  CHECK(boundary.y[0] == Approx(1.5));
  CHECK(boundary.y[3] == Approx(4.5));
  CHECK(std::isnan(boundary.y[4]));
  CHECK(boundary.distance == Approx(0.5));
}

TEST_CASE("the distance of a boundary is in cells") {
  const auto distance = [](double offset) {
    return find_boundary(diagonal(), Scale::linear, is_one, [offset](double x) { return x + 0.5 + offset; }).distance;
  };
  CHECK(distance(0) == Approx(0).margin(1e-12));
  CHECK(distance(1) == Approx(1));
  CHECK(distance(-2) == Approx(2));
}

TEST_CASE("without a boundary, the distance is that of the line from the edge of the map") {
  Map map = diagonal();
  for (auto& row : map.values) row.assign(row.size(), 0.0);
  const MapBoundary boundary = find_boundary(map, Scale::linear, is_one, [](double x) { return x; });
  CHECK(boundary.columns == 0);
  CHECK(boundary.distance == Approx(4.5));
}

TEST_CASE("cells of a logarithmic axis have equal ratios") {
  const std::vector<double> cells = spaced(1, 100, 3, Scale::log);
  CHECK(cells[1] == Approx(10));
  CHECK(cells[2] == Approx(100));
}
