// SPDX-License-Identifier: MIT
#include "measure/exact_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace ballpit {

namespace {

/// The spheres sorted by one coordinate, one array for each number.
struct SortedSpheres {
  int axis;
  std::array<std::vector<float>, 3> coordinate;  ///< [m] x, y, z
  std::vector<float> radius;                     ///< [m]
  std::vector<int32_t> index;                    ///< of the sphere in the caller's arrays
  float largest_radius = 0;
  Vec3 period{0};  ///< [m] 0: none
};

/// The axis along which the centres extend farthest: there, the fewest are near each other.
int longest_axis(const SphereArrays& spheres) {
  Vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (const Vec3& p : spheres.position) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const Vec3 extent = high - low;
  return extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
}

SortedSpheres sorted_along(int axis, const SphereArrays& spheres) {
  SortedSpheres sorted{axis, {}, {}, std::vector<int32_t>(static_cast<size_t>(spheres.position.size()))};
  std::iota(sorted.index.begin(), sorted.index.end(), 0);
  std::sort(sorted.index.begin(), sorted.index.end(),
            [&](int32_t a, int32_t b) { return spheres.position[a][axis] < spheres.position[b][axis]; });
  if (spheres.period) sorted.period = spheres.period->max - spheres.period->min;
  for (const int32_t i : sorted.index) {
    for (int k = 0; k < 3; ++k) sorted.coordinate[k].push_back(spheres.position[i][k]);
    sorted.radius.push_back(spheres.radius[spheres.radius.size() == 1 ? 0 : i]);
    sorted.largest_radius = std::max(sorted.largest_radius, sorted.radius.back());
  }
  return sorted;
}

/// The first sphere after a that is too far along the axis for any radius. Rounding never turns a ≤ b into a > b. So if
/// one squared difference exceeds the squared reach, the sum of three does too, for this sphere and all after it.
size_t end_of_reach(const SortedSpheres& spheres, size_t a) {
  const std::vector<float>& along = spheres.coordinate[spheres.axis];
  const float reach = spheres.radius[a] + spheres.largest_radius;
  const auto is_near = [&](float other) {
    const float d = other - along[a];
    return d * d <= reach * reach;
  };
  return static_cast<size_t>(std::partition_point(along.begin() + a + 1, along.end(), is_near) - along.begin());
}

/// The first sphere that a may reach across the end of a periodic axis; all after it are candidates as well. The reach
/// is enlarged by half to cover all rounding: the period is at least two reaches.
size_t begin_of_reach_across(const SortedSpheres& spheres, size_t a) {
  const std::vector<float>& along = spheres.coordinate[spheres.axis];
  const float reach = 1.5f * (spheres.radius[a] + spheres.largest_radius), period = spheres.period[spheres.axis];
  const auto is_apart = [&](float other) { return (other - along[a]) + reach < period; };
  return static_cast<size_t>(std::partition_point(along.begin() + a + 1, along.end(), is_apart) - along.begin());
}

/// A difference of coordinates; with a period, to the nearest image.
float nearest(float difference, float period) {
  return period == 0 ? difference : difference - period * std::nearbyint(difference / period);
}

/// The exact test. (a − b)² and (b − a)² are the same float.
bool overlaps(const SortedSpheres& spheres, size_t a, size_t b) {
  const auto& [x, y, z] = spheres.coordinate;
  const float dx = nearest(x[b] - x[a], spheres.period.x), dy = nearest(y[b] - y[a], spheres.period.y),
              dz = nearest(z[b] - z[a], spheres.period.z);
  const float sum = spheres.radius[a] + spheres.radius[b];
  return dx * dx + dy * dy + dz * dz <= sum * sum;
}

}  // namespace

std::vector<Pair> exact_pairs(const SphereArrays& spheres, const std::function<void(int64_t)>& tell) {
  const SortedSpheres sorted = sorted_along(longest_axis(spheres), spheres);
  std::vector<Pair> pairs;
  for (size_t a = 0; a < sorted.index.size(); ++a) {
    if (tell && a % 1024 == 0) tell(static_cast<int64_t>(a));
    const size_t end = end_of_reach(sorted, a);
    const auto test = [&](size_t b) {
      if (!overlaps(sorted, a, b)) return;
      const auto [i, j] = std::minmax(sorted.index[a], sorted.index[b]);
      pairs.push_back({i, j});
    };
    for (size_t b = a + 1; b < end; ++b) test(b);
    if (!spheres.period) continue;
    for (size_t b = std::max(end, begin_of_reach_across(sorted, a)); b < sorted.index.size(); ++b) test(b);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Deviation deviation_of(std::vector<Pair> found, const std::vector<Pair>& exact) {
  std::sort(found.begin(), found.end());
  const auto end = std::unique(found.begin(), found.end());
  Deviation deviation;
  deviation.duplicate = found.end() - end;
  int64_t right = 0;
  for (auto next = exact.begin(); const Pair& pair : std::span(found.begin(), end)) {
    next = std::lower_bound(next, exact.end(), pair);
    right += next != exact.end() && *next == pair;
  }
  deviation.wrong = (end - found.begin()) - right;
  deviation.missed = static_cast<int64_t>(exact.size()) - right;
  return deviation;
}

}  // namespace ballpit
