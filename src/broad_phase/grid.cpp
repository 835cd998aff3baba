// SPDX-License-Identifier: MIT
#include "broad_phase/grid.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <sstream>
#include <utility>

#include "broad_phase/inspection.h"
#include "core/error.h"
#include "core/span.h"

namespace ballpit {

namespace {

constexpr double kCellsPerBody = 16;      // beyond that, clearing empty cells and holding them costs more than it saves
constexpr double kLargestGrid = 1 << 30;  // cells; the index is an int
constexpr double kClassRatio =
    2.5;  // radii within a size class: fewer classes mean fewer rows, larger cells more tests
constexpr double kLargestPicture = 1 << 22;  // cells of a grid that is looked at

/// Cells along one axis: enough to cover the domain, or as many as fit where it repeats.
double cells_along(double extent, double edge, bool is_periodic) {
  const double cells = extent / edge;
  return std::max(1.0, is_periodic ? std::floor(cells) : std::ceil(cells));
}

template <class V>
double extent_of(const Box<V>& box, int axis) {
  return double(box.max[axis]) - double(box.min[axis]);
}

template <class V>
V choose_edge(const BroadPhaseParameters<V>& parameters, const SizeClass<V>& spheres, V edge, bool is_hashed) {
  using Real = Scalar<V>;
  if (parameters.cell_size) edge = V(static_cast<Real>(2.0 * double(spheres.largest) * *parameters.cell_size));
  // Rounding moves a coordinate counted in cells by its own unit in the last place, and by the guard.
  const bool is_unbounded = is_hashed && !parameters.box.is_periodic();
  edge *= is_unbounded ? Real(1.001) : Real(1) + 8 * std::numeric_limits<Real>::epsilon();
  edge += V(static_cast<Real>(2.0 * rounding_guard(parameters.box)));
  if (!parameters.cell_size && !is_unbounded) {
    const double most = is_hashed ? kLargestGrid : kCellsPerBody * double(spheres.count) + 4096.0;
    while (cell_count(parameters.box, edge) > most) edge *= Real(1.02);
  }
  return edge;
}

}  // namespace

template <class V>
std::vector<SizeClass<V>> size_classes(Span<const Scalar<V>> radius, int64_t count) {
  using Real = Scalar<V>;
  if (count == 0) return {};
  if (radius.size() == 1) return {{radius[0], count}};
  Real largest = radius[0], smallest = radius[0];
  for (const Real r : radius) {
    largest = r > largest ? r : largest;
    smallest = r < smallest ? r : smallest;
  }
  const double ratio = double(largest) / double(smallest);
  const int wanted = std::clamp(int(std::lround(std::log(ratio) / std::log(kClassRatio))), 1, kMaxSizeClasses);
  const double step = std::min(std::pow(ratio, 1.0 / wanted), kClassRatio * 1.5);
  Real bounds[kMaxSizeClasses];  // radii up to bounds[k] belong to class k or a finer one
  for (int k = 0; k < wanted; ++k)
    bounds[k] = k == 0 ? largest : static_cast<Real>(double(largest) / std::pow(step, k));
  std::vector<SizeClass<V>> classes(static_cast<size_t>(wanted));
  for (const Real r : radius) {
    int k = 0;
    while (k + 1 < wanted && r <= bounds[k + 1]) ++k;
    SizeClass<V>& spheres = classes[static_cast<size_t>(k)];
    spheres.largest = std::max(spheres.largest, r);
    ++spheres.count;
  }
  std::erase_if(classes, [](const SizeClass<V>& spheres) { return spheres.count == 0; });
  return classes;
}

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
    count *= cells_along(extent_of(box, axis), double(edge[axis]), box.is_periodic());
  }
  return count;
}

template <class V>
double occupied_volume(const Box<V>& box, Span<const Vec3> position) {
  constexpr int kSide = kDimensions<V> == 3 ? 32 : 181;
  constexpr int64_t kSample = 4096;
  std::vector<int> counts(size_t(std::pow(kSide, kDimensions<V>)), 0);
  const int64_t stride = std::max<int64_t>(1, position.size() / kSample);
  double together = 0, sample = 0, volume = 1;
  for (int64_t i = 0; i < position.size(); i += stride) {
    size_t cell = 0;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const double x = (double(position[i][axis]) - double(box.min[axis])) / std::max(1e-30, extent_of(box, axis));
      cell = cell * kSide + static_cast<size_t>(std::clamp(int(x * kSide), 0, kSide - 1));
    }
    together += counts[cell]++;
    ++sample;
  }
  for (int axis = 0; axis < kDimensions<V>; ++axis) volume *= extent_of(box, axis);
  if (sample < 2) return volume;
  // Two of an even sample share a cell with a probability of one in the number of cells.
  const double evenly = sample * (sample - 1) / 2 / double(counts.size());
  return volume * std::min(1.0, (evenly + 1) / (together + 1));
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
  if ((!is_hashed || grid.is_periodic) && !(count <= kLargestGrid)) {
    std::ostringstream found, allowed;
    found << parameters.cell_size.value_or(1.0) << ", which needs " << count << " cells";
    allowed << "sizes that need at most " << kLargestGrid << " cells"
            << (grid.is_periodic ? "" : ", or --table hashed");
    throw UserError("--cell-size", found.str(), allowed.str());
  }
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    const double extent = extent_of(box, axis);
    const double cells = std::min(cells_along(extent, double(edge[axis]), box.is_periodic()), kLargestGrid);
    const double length = box.is_periodic() ? extent / cells : double(edge[axis]);
    grid.cells[axis] = static_cast<int>(cells);
    grid.edge[axis] = static_cast<Scalar<V>>(length);
    grid.inverse_edge[axis] = static_cast<Scalar<V>>(1.0 / length);
    grid.farthest[axis] = static_cast<Scalar<V>>(std::min(2 * cells + 2048, kLargestGrid));
  }
  if (is_hashed) {
    grid.is_hashed = true;
    const int64_t places =
        std::max<int64_t>(8, 2 * spheres.count);  // fewer, and the cells of a row of a block would share one
    grid.mask = static_cast<unsigned>(std::bit_ceil(static_cast<uint64_t>(places))) - 1;
  }
  return grid;
}

template <class V>
GridInspection list_cells(const Grid<V>& grid, const std::vector<V>& position, const std::vector<int>& bodies) {
  GridInspection result = describe_grid(grid);
  const IVec3& cells = result.cells;
  if (double(cells.x) * cells.y * cells.z > kLargestPicture) return result;
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
  template std::vector<SizeClass<V>> size_classes<V>(Span<const Scalar<V>>, int64_t);              \
  template double rounding_guard(const Box<V>&);                                                   \
  template double cell_count(const Box<V>&, const V&);                                             \
  template double occupied_volume(const Box<V>&, Span<const Vec3>);                                \
  template Grid<V> make_grid(const BroadPhaseParameters<V>&, const SizeClass<V>&, const V&, bool); \
  template GridInspection list_cells(const Grid<V>&, const std::vector<V>&, const std::vector<int>&);
BALLPIT_INSTANTIATE(Vec2)
BALLPIT_INSTANTIATE(Vec3)
BALLPIT_INSTANTIATE(Vec2d)
BALLPIT_INSTANTIATE(Vec3d)
#undef BALLPIT_INSTANTIATE

}  // namespace ballpit
