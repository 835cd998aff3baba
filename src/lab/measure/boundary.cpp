// SPDX-License-Identifier: MIT
#include "lab/measure/boundary.h"

#include <algorithm>
#include <cmath>

namespace ballpit {

namespace {

double scaled(double value, Scale scale) { return scale == Scale::log ? std::log(value) : value; }

double unscaled(double value, Scale scale) { return scale == Scale::log ? std::exp(value) : value; }

/// The place of a value among evenly spaced cells: 0 in the first, 1 in the second; at most half a cell outside.
double place_among(const std::vector<double>& cells, double value, Scale scale) {
  const double last = static_cast<double>(cells.size() - 1);
  if (scale == Scale::log && value <= 0) return -0.5;
  const double low = scaled(cells.front(), scale), high = scaled(cells.back(), scale);
  return std::clamp((scaled(value, scale) - low) / (high - low) * last, -0.5, last + 0.5);
}

double value_at(const std::vector<double>& cells, double place, Scale scale) {
  const double last = static_cast<double>(cells.size() - 1);
  return unscaled(std::lerp(scaled(cells.front(), scale), scaled(cells.back(), scale), place / last), scale);
}

}  // namespace

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
    boundary.y.push_back(crosses ? value_at(map.y, place, y_scale) : kNoNumber);
    const double expected = place_among(map.y, theory(map.x[column]), y_scale);
    boundary.distance = std::max(boundary.distance, std::fabs(place - expected));
  }
  return boundary;
}

std::vector<double> spaced(double low, double high, int count, Scale scale) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) {
    values.push_back(unscaled(std::lerp(scaled(low, scale), scaled(high, scale), k / (count - 1.0)), scale));
  }
  return values;
}

}  // namespace ballpit
