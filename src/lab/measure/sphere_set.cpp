// SPDX-License-Identifier: MIT
#include "lab/measure/sphere_set.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "core/random.h"

namespace ballpit {

namespace {

constexpr double kDiameterVolume = std::numbers::pi / 6;  // of the largest sphere

/// [r_max] If 1/r² is uniform, the density of r is ~ r⁻³.
double draw_radius(double ratio, Random& random) { return 1 / std::sqrt(random.uniform(1, ratio * ratio)); }

/// The mean of r³ [r_max³] if 1/r² is uniform from 1 to q²: 2/(q² − 1)·(1 − 1/q).
double mean_cubed_radius(double ratio) { return ratio == 1 ? 1 : 2 / (ratio * (ratio + 1)); }

/// Gaussian with variance 1, as the sum of twelve uniform numbers: the same on every platform.
double gaussian(Random& random) {
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += random.uniform();
  return sum;
}

/// Durstenfeld 1964, Algorithm 235. Neighbours in space are then no neighbours in memory.
void shuffle(std::vector<Vec3>& places, Random& random) {
  for (size_t k = places.size(); k > 1; --k) std::swap(places[k - 1], places[random.bits() % k]);
}

}  // namespace

Vec3d box_of(const UniformSpheres& wanted) {
  const double spheres = static_cast<double>(wanted.count) * kDiameterVolume * mean_cubed_radius(wanted.size_ratio);
  const double width = std::cbrt(spheres / wanted.volume_fraction / wanted.aspect);
  return {width, width, width * wanted.aspect};
}

SphereSet uniform_spheres(const UniformSpheres& wanted, uint64_t seed) {
  Random random(seed);
  const Vec3d box = box_of(wanted);
  SphereSet set;
  for (int64_t i = 0; i < wanted.count; ++i) set.position.push_back(narrow<Vec3>(random.uniform(Vec3d(0.0), box)));
  if (wanted.size_ratio == 1) {
    set.radius = {0.5f};
  } else {
    for (int64_t i = 0; i < wanted.count; ++i) {
      set.radius.push_back(static_cast<float>(0.5 * draw_radius(wanted.size_ratio, random)));
    }
  }
  return set;
}

SphereSet touching_pairs(int64_t count, uint64_t seed) {
  constexpr double kSpacing = 4;        // the width of a pair is at most 2
  constexpr double kDistance = 0.9999;  // [diameters] of the centres, so that rounding keeps the contact
  Random random(seed);
  constexpr double kPlay = kSpacing / 2 - 1.001;
  const auto side = static_cast<int64_t>(std::ceil(std::cbrt(static_cast<double>(count) / 2) - 1e-9));
  SphereSet set;
  for (int64_t k = 0; k < count / 2; ++k) {
    const Vec3d site(static_cast<double>(k % side), static_cast<double>(k / side % side),
                     static_cast<double>(k / (side * side)));
    const Vec3d middle = (site + 0.5) * kSpacing + random.uniform(Vec3d(-kPlay), Vec3d(kPlay));
    const Vec3d half = 0.5 * kDistance * random.direction(3);
    set.position.push_back(narrow<Vec3>(middle - half));
    set.position.push_back(narrow<Vec3>(middle + half));
  }
  shuffle(set.position, random);
  set.radius = {0.5f};
  return set;
}

SphereSet clouds(int64_t count, uint64_t seed) {
  constexpr double kWidth = 3.5, kVolumeFraction = 0.01;
  Random random(seed);
  const Vec3d box(std::cbrt(static_cast<double>(count) * kDiameterVolume / kVolumeFraction));
  std::vector<Vec3d> centers;
  for (int64_t k = 0; k < std::max<int64_t>(1, count / 1000); ++k) centers.push_back(random.uniform(Vec3d(0.0), box));
  SphereSet set;
  for (int64_t i = 0; i < count; ++i) {
    const Vec3d center = centers[random.bits() % centers.size()];
    const double x = gaussian(random), y = gaussian(random), z = gaussian(random);
    set.position.push_back(narrow<Vec3>(center + kWidth * Vec3d(x, y, z)));
  }
  set.radius = {0.5f};
  return set;
}

}  // namespace ballpit
