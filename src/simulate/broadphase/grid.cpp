// SPDX-License-Identifier: MIT
#include "simulate/broadphase/grid.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "core/error.h"

namespace ballpit {

namespace {

constexpr double kCellsPerBody = 16;      // beyond that, clearing empty cells and holding them costs more than it saves
constexpr double kLargestGrid = 1 << 30;  // cells; the index is an int

/// Cells along one axis: enough to cover the domain, or as many as fit where it repeats.
double cells_along(double extent, double edge, bool is_periodic) {
  const double cells = extent / edge;
  return std::max(1.0, is_periodic ? std::floor(cells) : std::ceil(cells));
}

template <class V>
double cell_count(const Box<V>& box, double edge) {
  double count = 1.0;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    count *= cells_along(double(box.max[axis]) - box.min[axis], edge, box.is_periodic());
  }
  return count;
}

/// The relative widening of cells that makes up for rounding in cell_of(): a few units in the last place of the largest
/// coordinate, counted in cells.
template <class V>
double rounding_guard(const Box<V>& box, double edge) {
  double largest = 0.0;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    largest = std::max({largest, std::fabs(double(box.min[axis])), std::fabs(double(box.max[axis]))});
  }
  return 8.0 * double(std::numeric_limits<Scalar<V>>::epsilon()) * (1.0 + largest / edge);
}

template <class V>
double choose_edge(const BroadPhaseParameters<V>& parameters) {
  const double diameter = 2.0 * double(parameters.largest_radius);
  double edge = diameter * parameters.cell_size.value_or(1.0);
  edge *= 1.0 + rounding_guard(parameters.box, edge);
  if (!parameters.cell_size) {
    const double most = kCellsPerBody * double(parameters.count) + 4096.0;
    while (cell_count(parameters.box, edge) > most) edge *= 1.02;
  }
  return edge;
}

}  // namespace

template <class V>
Grid<V> make_grid(const BroadPhaseParameters<V>& parameters) {
  const Box<V>& box = parameters.box;
  Grid<V> grid;
  grid.origin = box.min;
  grid.is_periodic = box.is_periodic();
  if (parameters.count == 0) return grid;
  const double edge = choose_edge(parameters);
  const double count = cell_count(box, edge);
  if (!(count <= kLargestGrid)) {
    std::ostringstream message;
    message << "--cell-size: found " << parameters.cell_size.value_or(1.0) << ", which needs " << count
            << " cells; allowed are sizes that need at most " << kLargestGrid;
    throw UserError(message.str());
  }
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    const double extent = double(box.max[axis]) - box.min[axis];
    const double cells = cells_along(extent, edge, box.is_periodic());
    const double length = box.is_periodic() ? extent / cells : edge;
    grid.cells[axis] = static_cast<int>(cells);
    grid.edge[axis] = static_cast<Scalar<V>>(length);
    grid.inverse_edge[axis] = static_cast<Scalar<V>>(1.0 / length);
  }
  return grid;
}

template Grid<Vec2> make_grid(const BroadPhaseParameters<Vec2>&);
template Grid<Vec3> make_grid(const BroadPhaseParameters<Vec3>&);

}  // namespace ballpit
