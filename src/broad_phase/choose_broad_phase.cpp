// SPDX-License-Identifier: MIT
#include "broad_phase/choose_broad_phase.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "bodies/box.h"
#include "broad_phase/grid.h"
#include "core/error.h"
#include "core/span.h"

namespace ballpit {

namespace {

// Nanoseconds on one core, fitted to `ballpit pairs` on equal spheres. Only their rough ratios matter.
constexpr double kVectorTest = 0.35;  // a test in a long range
constexpr double kShortTest = 2.0;    // a test in a range of a few slots
constexpr double kListTest = 4.0;     // a test in a linked list
constexpr double kSort = 20.0;        // two endpoints sorted and numbered
constexpr double kBin = 35.0;         // a body sorted by cell, gathered, and its ranges looked up
constexpr double kLink = 90.0;        // a body linked, and the cells around it looked up
constexpr double kCell = 0.6;         // a cell cleared and read

struct Prediction {
  BroadPhase method;
  double nanoseconds;
};

/// The expected number of centres in `volume`, of `count` spheres spread evenly over the box.
template <class V>
double expected(const Box<V>& box, double count, double volume) {
  double whole = 1;
  for (int axis = 0; axis < kDimensions<V>; ++axis) whole *= std::max(1e-30, box.extent(axis));
  return std::min(count, count * volume / whole);
}

/// The volume of the block of cells around a sphere.
template <class V>
double block_volume(const Box<V>& box, double edge) {
  double volume = 1;
  for (int axis = 0; axis < kDimensions<V>; ++axis) volume *= std::min(3 * edge, box.extent(axis));
  return volume;
}

template <class V>
Prediction predict_sorted_grid(const BroadPhaseParameters<V>& p) {
  double time = 0, coarser = 0;
  for (const SizeClass<V>& spheres : p.classes) {
    const double n = double(spheres.count), edge = 2 * double(spheres.largest) * p.cell_size.value_or(1.0);
    time += n * kBin + n * kShortTest * expected(p.box, n, block_volume(p.box, edge)) / 2;
    time += std::min(cell_count(p.box, V(static_cast<Scalar<V>>(edge))), 6 * n) * kCell;
    time += coarser * kShortTest * expected(p.box, n, block_volume(p.box, 4 * double(spheres.largest)));
    coarser += n;
  }
  return {BroadPhase::sorted_grid, time};
}

template <class V>
Prediction predict_sweep(const BroadPhaseParameters<V>& p) {
  const double n = double(p.count);
  double longest = 0, diameter = 0;
  for (int axis = 0; axis < kDimensions<V>; ++axis) longest = std::max(longest, p.box.extent(axis));
  for (const SizeClass<V>& spheres : p.classes) diameter += 1.5 * double(spheres.largest) * double(spheres.count) / n;
  return {BroadPhase::sort_and_sweep, n * (kSort + 40) + kVectorTest * n * std::min(n / 2, n * diameter / longest)};
}

template <class V>
Prediction predict_linked_cell(const BroadPhaseParameters<V>& p) {
  const double n = double(p.count), edge = 2 * double(p.largest_radius()) * p.cell_size.value_or(1.0);
  return {BroadPhase::linked_cell, n * kLink + n * kListTest * expected(p.box, n, block_volume(p.box, edge))};
}

template <class V>
Prediction predict_brute_force(const BroadPhaseParameters<V>& p) {
  const double n = double(p.count);
  return {BroadPhase::brute_force, n * 10 + kVectorTest * n * n / 2};
}

}  // namespace

template <class V>
BroadPhaseChoice choose_broad_phase(const Settings& settings, const BroadPhaseParameters<V>& parameters) {
  if (settings.broadphase != BroadPhase::automatic) return {settings.broadphase, ""};
  if (parameters.count < 2) return {BroadPhase::brute_force, "fewer than two spheres"};
  std::array predictions{predict_sorted_grid(parameters), predict_sweep(parameters), predict_linked_cell(parameters),
                         predict_brute_force(parameters)};
  std::sort(predictions.begin(), predictions.end(),
            [](const Prediction& a, const Prediction& b) { return a.nanoseconds < b.nanoseconds; });
  std::vector<std::string> times;
  for (const Prediction& p : predictions)
    times.push_back(fmt::format("{} {:.2g}", name_of(p.method), p.nanoseconds * 1e-6));
  return {predictions.front().method,
          fmt::format("predicted for {} spheres, ms on one core: {}", parameters.count, fmt::join(times, ", "))};
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

#define BALLPIT_INSTANTIATE(V)                                                                                   \
  template BroadPhaseChoice choose_broad_phase(const Settings&, const BroadPhaseParameters<V>&);                 \
  template BroadPhaseParameters<V> broad_phase_parameters(const Settings&, const Box<V>&, Span<const Scalar<V>>, \
                                                          int64_t);

BALLPIT_INSTANTIATE(Vec2)
BALLPIT_INSTANTIATE(Vec3)
BALLPIT_INSTANTIATE(Vec2d)
BALLPIT_INSTANTIATE(Vec3d)

}  // namespace ballpit
