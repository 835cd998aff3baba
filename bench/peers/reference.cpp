// SPDX-License-Identifier: MIT
#include "reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.h"

namespace ballpit {

namespace {

using Cell = std::array<int64_t, 3>;

/// A linked list of bodies for each cell.
class Cells {
 public:
  explicit Cells(const Spheres& spheres) : next_(spheres.position.size(), -1) {
    Vec3d high(spheres.position.front());
    low_ = high;
    for (const Vec3& p : spheres.position) {
      low_ = glm::min(low_, Vec3d(p));
      high = glm::max(high, Vec3d(p));
    }
    edge_ = 2.0 * *std::max_element(spheres.radius.begin(), spheres.radius.end());
    while (size_for(high) > std::max<double>(1000.0, static_cast<double>(spheres.count()))) edge_ *= 1.25;
    for (int axis = 0; axis < 3; ++axis) size_[axis] = static_cast<int64_t>((high[axis] - low_[axis]) / edge_) + 1;
    head_.assign(static_cast<size_t>(size_[0] * size_[1] * size_[2]), -1);
    for (size_t i = 0; i < spheres.position.size(); ++i) {
      int32_t& head = head_[index_of(cell_of(spheres.position[i]))];
      next_[i] = head;
      head = static_cast<int32_t>(i);
    }
  }

  Cell cell_of(const Vec3& position) const {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) cell[axis] = static_cast<int64_t>((position[axis] - low_[axis]) / edge_);
    return cell;
  }

  /// Calls visit(body) for the bodies of the 27 cells around a position.
  template <class Visit>
  void near(const Vec3& position, Visit visit) const {
    const Cell centre = cell_of(position);
    Cell low;
    Cell high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::max<int64_t>(0, centre[axis] - 1);
      high[axis] = std::min(size_[axis] - 1, centre[axis] + 1);
    }
    for (int64_t z = low[2]; z <= high[2]; ++z) {
      for (int64_t y = low[1]; y <= high[1]; ++y) {
        for (int64_t x = low[0]; x <= high[0]; ++x) {
          for (int32_t j = head_[index_of({x, y, z})]; j >= 0; j = next_[static_cast<size_t>(j)]) visit(j);
        }
      }
    }
  }

 private:
  double size_for(const Vec3d& high) const {
    const Vec3d cells = (high - low_) / edge_ + 1.0;
    return cells.x * cells.y * cells.z;
  }

  size_t index_of(const Cell& cell) const {
    return static_cast<size_t>((cell[2] * size_[1] + cell[1]) * size_[0] + cell[0]);
  }

  Vec3d low_{};
  double edge_ = 0;
  Cell size_{};
  std::vector<int32_t> head_;
  std::vector<int32_t> next_;
};

bool overlap(const Spheres& spheres, int32_t i, int32_t j) {
  const Vec3d d = Vec3d(spheres.position[static_cast<size_t>(i)]) - Vec3d(spheres.position[static_cast<size_t>(j)]);
  const double sum = static_cast<double>(spheres.radius_of(i)) + spheres.radius_of(j);
  return dot(d, d) <= sum * sum;
}

}  // namespace

std::vector<Pair> reference_pairs(const Spheres& spheres) {
  const Cells cells(spheres);
  std::vector<Pair> pairs;
  for (int32_t i = 0; i < static_cast<int32_t>(spheres.count()); ++i) {
    const auto first = static_cast<std::ptrdiff_t>(pairs.size());
    cells.near(spheres.position[static_cast<size_t>(i)], [&](int32_t j) {
      if (i < j && overlap(spheres, i, j)) pairs.push_back({i, j});
    });
    std::sort(pairs.begin() + first, pairs.end(), [](const Pair& a, const Pair& b) { return a.j < b.j; });
  }
  return pairs;
}

PairSet pair_set(const std::vector<Pair>& pairs) {
  PairSet set{static_cast<int64_t>(pairs.size()), 0};
  for (const Pair& pair : pairs) {
    const auto low = static_cast<uint64_t>(std::min(pair.i, pair.j));
    const auto high = static_cast<uint64_t>(std::max(pair.i, pair.j));
    set.hash += Random(low << 32 | high).bits();
  }
  return set;
}

}  // namespace ballpit
