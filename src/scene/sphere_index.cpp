// SPDX-License-Identifier: MIT
#include "scene/sphere_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace ballpit {

namespace {

Vec3d cell_at(const Vec3d& position, double cell) { return glm::floor(position * (1.0 / cell)); }

/// Above this, neighbouring cells have the same floating-point coordinate.
constexpr double kLargestCell = 0x1p52;

bool is_exact(const Vec3d& cell) {
  return std::abs(cell.x) < kLargestCell && std::abs(cell.y) < kLargestCell && std::abs(cell.z) < kLargestCell;
}

}  // namespace

std::vector<int32_t> by_descending_radius(const std::vector<double>& radius, int64_t first, int64_t end) {
  std::vector<int32_t> order(static_cast<size_t>(end - first));
  std::iota(order.begin(), order.end(), static_cast<int32_t>(first));
  std::stable_sort(order.begin(), order.end(), [&](int32_t i, int32_t j) {
    return radius[static_cast<size_t>(i)] > radius[static_cast<size_t>(j)];
  });
  return order;
}

void SphereIndex::insert(int32_t id, const Vec3d& position, double radius) {
  Level& level = level_of(radius);
  if (level.spheres.size() == level.head.size()) grow(level);
  level.largest = std::max(level.largest, radius);
  largest_ = std::max(largest_, radius);
  const Vec3d cell = cell_at(position, level.cell);
  int32_t next = -1;
  if (is_exact(cell)) {
    next = std::exchange(level.head[bucket(level, cell)], static_cast<int32_t>(level.spheres.size()));
  }
  level.spheres.push_back({position, radius, id, next});
  ++size_;
}

SphereIndex::Level& SphereIndex::level_of(double radius) {
  const int exponent = std::ilogb(2.0 * radius);
  const auto known = std::ranges::find(levels_, exponent, &Level::exponent);
  if (known != levels_.end()) return *known;
  Level& level = levels_.emplace_back();
  level.exponent = exponent;
  level.cell = std::ldexp(1.0, exponent + 1);
  return level;
}

/// Doubles the buckets and links all spheres again, in the order of insertion.
void SphereIndex::grow(Level& level) {
  level.head.assign(std::max<size_t>(16, 2 * level.head.size()), -1);
  for (size_t i = 0; i < level.spheres.size(); ++i) {
    const Vec3d cell = cell_at(level.spheres[i].position, level.cell);
    if (!is_exact(cell)) continue;
    level.spheres[i].next = std::exchange(level.head[bucket(level, cell)], static_cast<int32_t>(i));
  }
}

/// Neighbours in x are in neighbouring buckets, so a row of cells needs one or two cache lines.
size_t SphereIndex::bucket(const Level& level, const Vec3d& cell) {
  const auto x = static_cast<uint64_t>(static_cast<int64_t>(cell.x));
  const auto y = static_cast<uint64_t>(static_cast<int64_t>(cell.y));
  const auto z = static_cast<uint64_t>(static_cast<int64_t>(cell.z));
  const uint64_t row = (y * 0x9E3779B97F4A7C15u) ^ (z * 0xC2B2AE3D27D4EB4Fu);
  return static_cast<size_t>((row >> 32) + x) & (level.head.size() - 1);
}

SphereIndex::CellRange SphereIndex::cells_in_reach(const Level& level, const Vec3d& position, double reach) const {
  CellRange range{cell_at(position - reach, level.cell), cell_at(position + reach, level.cell), 0.0};
  if (domain_.dimensions == 2) range.low.z = range.high.z = 0.0;
  const Vec3d extent = range.high - range.low + 1.0;
  const bool countable = is_exact(range.low) && is_exact(range.high);
  range.count = countable ? extent.x * extent.y * extent.z : std::numeric_limits<double>::infinity();
  return range;
}

int SphereIndex::images(const Vec3d& position, double reach, Vec3d (&image)[27]) const {
  image[0] = position;
  int count = 1;
  if (domain_.boundary != Boundary::periodic) return count;
  for (int axis = 0; axis < domain_.dimensions; ++axis) {
    const double edge = domain_.max[axis] - domain_.min[axis];
    const int before = count;
    for (const double shift : {edge, -edge}) {
      const double shifted = position[axis] + shift;
      if (shifted < domain_.min[axis] - reach || shifted > domain_.max[axis] + reach) continue;
      for (int k = 0; k < before; ++k) {
        image[count] = image[k];
        image[count++][axis] = shifted;
      }
    }
  }
  return count;
}

}  // namespace ballpit
