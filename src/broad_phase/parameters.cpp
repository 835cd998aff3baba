// SPDX-License-Identifier: MIT
#include "broad_phase/parameters.h"

#include <algorithm>
#include <cmath>

namespace ballpit {

namespace {

constexpr double kClassRatio = 2.5;  // of radii in a size class: fewer classes mean larger cells and more tests

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
double occupied_volume(const Box<V>& box, Span<const Vec3> position) {
  constexpr int kSide = kDimensions<V> == 3 ? 32 : 181;
  constexpr int64_t kSample = 4096;
  std::vector<int> counts(size_t(std::pow(kSide, kDimensions<V>)), 0);
  const int64_t stride = std::max<int64_t>(1, position.size() / kSample);
  double together = 0, sample = 0, volume = 1;
  for (int64_t i = 0; i < position.size(); i += stride) {
    size_t cell = 0;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      const double x = (double(position[i][axis]) - double(box.min[axis])) / std::max(1e-30, box.extent(axis));
      cell = cell * kSide + static_cast<size_t>(std::clamp(int(x * kSide), 0, kSide - 1));
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

#define BALLPIT_INSTANTIATE(V)                                                        \
  template std::vector<SizeClass<V>> size_classes<V>(Span<const Scalar<V>>, int64_t); \
  template double occupied_volume(const Box<V>&, Span<const Vec3>);
BALLPIT_INSTANTIATE(Vec2)
BALLPIT_INSTANTIATE(Vec3)
BALLPIT_INSTANTIATE(Vec2d)
BALLPIT_INSTANTIATE(Vec3d)
#undef BALLPIT_INSTANTIATE

}  // namespace ballpit
