// SPDX-License-Identifier: MIT
// The domain: what wrap() returns is inside, and the cells computed from it are in the grid.
#include "bodies/box.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "bodies/bodies_view.h"
#include "broad_phase/linked_cell.h"
#include "broad_phase/parameters.h"
#include "broad_phase/sorted_grid.h"
#include "core/random.h"
#include "exec/cpu_executor.h"

using namespace ballpit;

namespace {

template <class V>
bool is_inside(const Box<V>& box, const V& p) {
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    if (!(p[axis] >= box.min[axis] && p[axis] < box.max[axis])) return false;
  }
  return true;
}

/// Domains near the origin and far from it, tiny and huge.
template <class V>
std::vector<Box<V>> periodic_boxes() {
  using Real = Scalar<V>;
  std::vector<Box<V>> boxes;
  for (const double low : {0.0, 0.7, 100.7, -5000.3, -1e-7, 3e5}) {
    for (const double size : {1.0, 0.1, 1e-6, 1e9}) {
      const Real min = Real(low), max = Real(low + size);
      if (min < max) boxes.push_back({V(min), V(max), Boundary::periodic});
    }
  }
  return boxes;
}

template <class V>
void check_wrap() {
  using Real = Scalar<V>;
  constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
  Random random(3);
  for (const Box<V>& box : periodic_boxes<V>()) {
    const Real low = box.min[0], high = box.max[0], size = high - low;
    std::vector<Real> positions{low,
                                high,
                                std::nextafter(low, -kInfinity),
                                std::nextafter(low, kInfinity),
                                std::nextafter(high, -kInfinity),
                                std::nextafter(high, kInfinity),
                                Real(0),
                                Real(1e30),
                                Real(-1e30),
                                std::numeric_limits<Real>::max(),
                                std::numeric_limits<Real>::denorm_min()};
    for (int k = 0; k < 200; ++k) positions.push_back(low + size * Real(random.uniform(-3, 3)));
    for (int k = 0; k < 60; ++k)
      positions.push_back(size * std::pow(Real(10), Real(random.uniform(0, 30))) * (k % 2 == 0 ? 1 : -1));
    for (const Real x : positions) {
      if (!std::isfinite(x)) continue;
      CAPTURE(low, high, x);
      const V wrapped = box.wrap(V(x));
      CHECK(is_inside(box, wrapped));
      CHECK(box.holds(wrapped));
      if (x >= low && x < high) CHECK(wrapped[0] == x);  // to the bit
    }
    for (const Real x : {std::numeric_limits<Real>::quiet_NaN(), kInfinity, -kInfinity}) {
      CHECK_FALSE(box.holds(box.wrap(V(x))));  // so that the guard stops the run
    }
  }
}

}  // namespace

TEST_CASE("what is wrapped into a periodic domain is inside, below its upper end") {
  check_wrap<Vec3>();
  check_wrap<Vec2>();
  check_wrap<Vec3d>();
}

TEST_CASE("a periodic domain holds what is inside, and nothing else") {
  const Box<Vec3> box{Vec3(0), Vec3(1), Boundary::periodic};
  CHECK(box.holds(Vec3(0.5f)));
  CHECK(box.holds(Vec3(0)));
  for (const float x : {-0.5f, 1.5f, 1e20f, std::numeric_limits<float>::quiet_NaN()}) {
    CHECK_FALSE(box.holds(Vec3(x, 0.5f, 0.5f)));
  }
}

namespace {

/// Builds a broad phase of these positions and walks all its candidates: each must be a body.
template <template <class, class> class Method>
void walk(const Box<Vec3>& box, const std::vector<Vec3>& position, CellTable table, std::optional<double> cell_size) {
  const std::vector<float> radius{0.05f, 0.01f};
  std::vector<float> radii;
  for (size_t i = 0; i < position.size(); ++i) radii.push_back(radius[i % 2]);
  const auto count = static_cast<int64_t>(position.size());
  Settings settings;
  auto parameters = broad_phase_parameters<Vec3>(settings, box, {radii.data(), count}, count);
  parameters.table = table;
  parameters.cell_size = cell_size;
  CpuExecutor exec(1);
  Method<Vec3, CpuExecutor> method(parameters);
  const float inverse_mass = 1;
  const BodiesView<Vec3> bodies{{position.data(), count}, {}, {radii.data(), 1}, {&inverse_mass, 0}};
  method.prepare(exec, bodies);
  const auto candidates = method.candidates();
  int64_t wrong = 0;
  if constexpr (requires { candidates.threads(); }) {
    for (int slot = 0; slot < candidates.threads(); ++slot) {
      candidates.for_each_range(
          slot, [&](const SlotRange& range) { wrong += range.size() > 0 && (range.first < 0 || range.last > count); });
    }
  } else {
    for (int i = 0; i < count; ++i) {
      candidates.for_each(i, [&](int j) {
        wrong += j < 0 || j >= count;
        return true;
      });
    }
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("grids take positions that are no numbers, infinite, far away or at the edge") {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  Random random(8);
  std::vector<Vec3> position;
  const Box<Vec3> period{Vec3(100.7f), Vec3(101.7f), Boundary::periodic};
  for (int k = 0; k < 200; ++k) position.push_back(narrow<Vec3>(random.uniform(Vec3d(100.7), Vec3d(101.7))));
  for (const float x : {kNaN, kInfinity, -kInfinity, 1e30f, -1e30f, 3e38f, 100.7f, 101.7f, 0.0f, 100.69999f}) {
    position.insert(position.end(), {Vec3(x), Vec3(x, 101, 101), Vec3(101, x, 101), Vec3(101, 101, x)});
  }
  for (const Boundary boundary : {Boundary::periodic, Boundary::walls, Boundary::open_top}) {
    Box<Vec3> box = period;
    box.boundary = boundary;
    for (const CellTable table : {CellTable::dense, CellTable::hashed}) {
      for (const std::optional<double> cell_size : {std::optional<double>(), std::optional(1.0), std::optional(3.0)}) {
        CAPTURE(int(boundary), int(table), cell_size.value_or(0));
        walk<SortedGrid>(box, position, table, cell_size);
        walk<LinkedCell>(box, position, table, cell_size);
      }
    }
  }
}
