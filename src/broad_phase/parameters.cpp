// SPDX-License-Identifier: MIT
#include "broad_phase/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "broad_phase/grid.h"
#include "core/error.h"

namespace ballpit {

namespace {

constexpr double kClassRatio = 2.5;  // of radii in a size class: fewer classes mean larger cells and more tests

constexpr double kCell = 0.6;  // [ns] a cell cleared and read

struct Prediction {
  BroadPhase method;
  double nanoseconds;
};

/// The expected number of centres in the block of cells around a sphere, of `count` spheres spread evenly over the box.
template <class V>
double expected_in_block(const Box<V>& box, double count, double edge) {
  double block = 1, whole = 1;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    block *= std::min(3 * edge, box.extent(axis));
    whole *= std::max(1e-30, box.extent(axis));
  }
  return std::min(count, count * block / whole);
}

/// For all methods, the fastest first.
template <class V>
std::array<Prediction, 4> predict(const BroadPhaseParameters<V>& p, const SearchCosts& costs) {
  const double n = double(p.count), cell_size = p.cell_size.value_or(1.0);
  double sorted_grid = 0, coarser = 0, diameter = 0, longest = 0;
  for (const SizeClass<V>& spheres : p.classes) {
    const double count = double(spheres.count), largest = double(spheres.largest), edge = 2 * largest * cell_size;
    sorted_grid += count * costs.bin + count * costs.short_test * expected_in_block(p.box, count, edge) / 2;
    sorted_grid += std::min(cell_count(p.box, V(static_cast<Scalar<V>>(edge))), 6 * count) * kCell;
    sorted_grid += coarser * costs.short_test * expected_in_block(p.box, count, 4 * largest);
    coarser += count;
    diameter += 1.5 * largest * count / n;
  }
  for (int axis = 0; axis < kDimensions<V>; ++axis) longest = std::max(longest, p.box.extent(axis));
  const double sweep = n * costs.sort + costs.sweep_test * n * std::min(n / 2, n * diameter / longest);
  const double in_block = expected_in_block(p.box, n, 2 * double(p.largest_radius()) * cell_size);
  std::array predictions{Prediction{BroadPhase::sorted_grid, sorted_grid},
                         Prediction{BroadPhase::sort_and_sweep, sweep},
                         Prediction{BroadPhase::linked_cell, n * costs.link + n * costs.list_test * in_block},
                         Prediction{BroadPhase::brute_force, n * costs.each + costs.vector_test * n * n / 2}};
  std::ranges::sort(predictions, {}, &Prediction::nanoseconds);
  return predictions;
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
  for (int k = wanted - 1; k >= 0; --k) {  // a pass for each class, without branches
    Real most = 0;
    int count_to = 0;
    for (const Real r : radius) {
      most = r <= bounds[k] && r > most ? r : most;
      count_to += int(r <= bounds[k]);
    }
    classes[static_cast<size_t>(k)] = {most, count_to};
  }
  for (size_t k = 0; k + 1 < classes.size(); ++k) classes[k].count -= classes[k + 1].count;
  std::erase_if(classes, [](const SizeClass<V>& spheres) { return spheres.count == 0; });
  return classes;
}

template <class V>
double occupied_volume(const Box<V>& box, Span<const Vec3> position) {
  constexpr int kSide = kDimensions<V> == 3 ? 32 : 181;
  constexpr int64_t kSample = 4096;
  std::vector<int> counts(size_t(std::pow(kSide, kDimensions<V>)), 0);
  const int64_t stride = std::max<int64_t>(1, position.size() / kSample);
  double together = 0, sample = 0, volume = 1, cells_per_length[3] = {};
  for (int axis = 0; axis < kDimensions<V>; ++axis) cells_per_length[axis] = kSide / std::max(1e-30, box.extent(axis));
  for (int64_t i = 0; i < position.size(); i += stride) {
    size_t cell = 0;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const double x = (double(position[i][axis]) - double(box.min[axis])) * cells_per_length[axis];
      cell = cell * kSide + static_cast<size_t>(std::clamp(int(x), 0, kSide - 1));
    }
    together += counts[cell]++;
    ++sample;
  }
  for (int axis = 0; axis < kDimensions<V>; ++axis) volume *= box.extent(axis);
  if (sample < 2) return volume;
  // If the sample is spread evenly, two of its points share a cell with probability 1 / number of cells.
  const double evenly = sample * (sample - 1) / 2 / double(counts.size());
  return volume * std::min(1.0, (evenly + 1) / (together + 1));
}

template <class V>
BroadPhaseParameters<V> broad_phase_parameters(const Settings& settings, const Box<V>& box,
                                               Span<const Scalar<V>> radius, int64_t count) {
  BroadPhaseParameters<V> parameters;
  parameters.box = box;
  parameters.count = count;
  parameters.classes = size_classes<V>(radius, count);
  parameters.cell_size = settings.cell_size;
  parameters.table = settings.table;
  if (settings.axis != SweepAxis::automatic) {
    parameters.axis = static_cast<int>(settings.axis) - static_cast<int>(SweepAxis::x);
    if (parameters.axis >= kDimensions<V>) throw UserError("--axis", "z", "auto, x, y in a planar scene");
  }
  return parameters;
}

template <class V>
BroadPhaseChoice choose_broad_phase(const Settings& settings, const BroadPhaseParameters<V>& parameters) {
  if (settings.broadphase != BroadPhase::automatic) return {settings.broadphase, ""};
  if (parameters.count < 2) return {BroadPhase::brute_force, "fewer than two spheres"};
  const std::array<Prediction, 4> predictions = predict(parameters, settings.costs);
  std::vector<std::string> times;
  for (const Prediction& p : predictions)
    times.push_back(fmt::format("{} {:.2g}", name_of(p.method), p.nanoseconds * 1e-6));
  return {predictions.front().method,
          fmt::format("predicted for {} spheres, ms on one core: {}", parameters.count, fmt::join(times, ", "))};
}

#define BALLPIT_INSTANTIATE(V)                                                                                   \
  template std::vector<SizeClass<V>> size_classes<V>(Span<const Scalar<V>>, int64_t);                            \
  template double occupied_volume(const Box<V>&, Span<const Vec3>);                                              \
  template BroadPhaseChoice choose_broad_phase(const Settings&, const BroadPhaseParameters<V>&);                 \
  template BroadPhaseParameters<V> broad_phase_parameters(const Settings&, const Box<V>&, Span<const Scalar<V>>, \
                                                          int64_t);
BALLPIT_INSTANTIATE(Vec2)
BALLPIT_INSTANTIATE(Vec3)
BALLPIT_INSTANTIATE(Vec2d)
BALLPIT_INSTANTIATE(Vec3d)
#undef BALLPIT_INSTANTIATE

}  // namespace ballpit
