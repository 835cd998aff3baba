// SPDX-License-Identifier: MIT
#include "broad_phase/grid.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"

namespace ballpit {

namespace {

constexpr double kMaxCellsPerBody = 16;      // beyond that, clearing and storing empty cells costs more than it saves
constexpr double kMaxCells = 1 << 30;        // the index is an int
constexpr double kMaxListedCells = 1 << 22;  // of a grid that is shown

/// Cells along one axis: enough to cover the domain, or as many as fit into a periodic one.
double cells_along(double extent, double edge, bool is_periodic) {
  const double cells = extent / edge;
  return std::max(1.0, is_periodic ? std::floor(cells) : std::ceil(cells));
}

template <class V>
V choose_edge(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres, V edge, bool is_hashed) {
  using Real = Scalar<V>;
  if (parameters.cell_size) edge = V(static_cast<Real>(2.0 * double(spheres.largest) * *parameters.cell_size));
  // Rounding moves a coordinate in units of cells by its own unit in the last place, and by the guard.
  const bool is_unbounded = is_hashed && !parameters.box.is_periodic();
  edge *= is_unbounded ? Real(1.001) : Real(1) + 8 * std::numeric_limits<Real>::epsilon();
  edge += V(static_cast<Real>(2.0 * rounding_guard(parameters.box)));
  if (!parameters.cell_size && !is_unbounded) {
    const double limit = is_hashed ? kMaxCells : kMaxCellsPerBody * double(spheres.count) + 4096.0;
    while (cell_count(parameters.box, edge) > limit) edge *= Real(1.02);
  }
  return edge;
}

}  // namespace

template <class V>
double rounding_guard(const Box<V>& box) {
  double largest = 0.0;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    largest = std::max({largest, std::fabs(double(box.min[axis])), std::fabs(double(box.max[axis]))});
  }
  return 4.0 * double(std::numeric_limits<Scalar<V>>::epsilon()) * largest;
}

template <class V>
double cell_count(const Box<V>& box, const V& edge) {
  double count = 1.0;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    count *= cells_along(box.extent(axis), double(edge[axis]), box.is_periodic());
  }
  return count;
}

template <class V>
Grid<V> make_grid(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres, const V& wanted_edge,
                  bool is_hashed) {
  const Box<V>& box = parameters.box;
  Grid<V> grid;
  grid.origin = box.min;
  grid.is_periodic = box.is_periodic();
  if (spheres.count == 0) return grid;
  const V edge = choose_edge(parameters, spheres, wanted_edge, is_hashed);
  const double count = cell_count(box, edge);
  if ((!is_hashed || grid.is_periodic) && !(count <= kMaxCells)) {
    throw UserError(
        "--cell-size", fmt::format("{:g}, which needs {:g} cells", parameters.cell_size.value_or(1.0), count),
        fmt::format("sizes that need at most {:g} cells{}", kMaxCells, grid.is_periodic ? "" : ", or --table hashed"));
  }
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    const double extent = box.extent(axis);
    const double cells = std::min(cells_along(extent, double(edge[axis]), box.is_periodic()), kMaxCells);
    const double length = box.is_periodic() ? extent / cells : double(edge[axis]);
    grid.cells[axis] = static_cast<int>(cells);
    grid.edge[axis] = static_cast<Scalar<V>>(length);
    grid.inverse_edge[axis] = static_cast<Scalar<V>>(1.0 / length);
    grid.farthest[axis] = static_cast<Scalar<V>>(std::min(2 * cells + 2048, kMaxCells));
  }
  if (is_hashed) {
    grid.is_hashed = true;
    // With fewer than 8 buckets, the cells of a block's row would share one.
    const int64_t buckets = std::max<int64_t>(8, 2 * spheres.count);
    grid.mask = static_cast<unsigned>(std::bit_ceil(static_cast<uint64_t>(buckets))) - 1;
  }
  return grid;
}

template <class V>
GridInspection describe_grid(const Grid<V>& grid) {
  GridInspection result;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    result.cells[axis] = grid.cells[axis] - 2 * grid.border;
    result.origin[axis] = static_cast<float>(grid.origin[axis] + grid.edge[axis] * Scalar<V>(grid.border));
    result.edge[axis] = static_cast<float>(grid.edge[axis]);
  }
  if constexpr (kDimensions<V> == 2) result.cells.z = 1;
  return result;
}

template <class V>
GridInspection list_cells(const Grid<V>& grid, const std::vector<V>& position, const std::vector<int>& bodies) {
  GridInspection result = describe_grid(grid);
  const IVec3& cells = result.cells;
  if (double(cells.x) * cells.y * cells.z > kMaxListedCells) return result;
  IVec3 border(0);
  for (int axis = 0; axis < kDimensions<V>; ++axis) border[axis] = grid.border;
  result.head.assign(static_cast<size_t>(cells.x) * cells.y * cells.z, -1);
  result.next.assign(position.size(), -1);
  for (const int body : bodies) {
    const IVec3 cell = glm::clamp(grid.cell_of(position[static_cast<size_t>(body)]) - border, IVec3(0), cells - 1);
    int32_t& head = result.head[(static_cast<size_t>(cell.z) * cells.y + cell.y) * cells.x + cell.x];
    result.next[static_cast<size_t>(body)] = std::exchange(head, body);
  }
  return result;
}

#define BALLPIT_INSTANTIATE(V)                                                                     \
  template double rounding_guard(const Box<V>&);                                                   \
  template double cell_count(const Box<V>&, const V&);                                             \
  template Grid<V> make_grid(const BroadPhaseParameters<V>&, const SizeClass<V>&, const V&, bool); \
  template GridInspection describe_grid(const Grid<V>&);                                           \
  template GridInspection list_cells(const Grid<V>&, const std::vector<V>&, const std::vector<int>&);
BALLPIT_INSTANTIATE(Vec2)
BALLPIT_INSTANTIATE(Vec3)
BALLPIT_INSTANTIATE(Vec2d)
BALLPIT_INSTANTIATE(Vec3d)
#undef BALLPIT_INSTANTIATE

}  // namespace ballpit
