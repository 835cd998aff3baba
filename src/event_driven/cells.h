// SPDX-License-Identifier: MIT
// The cells of event-driven motion: cell lists as in broad_phase/linked_cell.h, changed by one sphere at a time.
//
//     a periodic row of three cells, and what is around cell 0:
//
//         ┆ 2 − L │  0  │  1  │  2  ┆        the left neighbour of cell 0 is cell 2, shifted by −L; in a row of two
//            ▲───────█─────▲                 cells, cell 1 is both neighbours, on the left shifted by −L
//
// In a periodic domain, the block around a cell consists of cells of the domain and of its images, so the same rule
// holds even for a single cell. The outermost cells of a domain with walls end at the walls; under an open top the
// uppermost cells have no upper end. Edges are at least the largest diameter, so that spheres in contact lie in
// neighbouring cells, and longer if the domain would have more cells than `limit`. Cost: 4 bytes a cell, 4 a sphere.
#pragma once

#include <array>
#include <vector>

#include "bodies/box.h"
#include "event_driven/flight.h"

namespace ballpit {

/// Which cells of a block are visited: all, or only those ahead of a sphere that has entered its cell along an axis.
struct BlockPart {
  int axis = -1;  ///< −1: all
  int side = 0;   ///< −1 or +1
};

/// A sphere in a block, and the number of its image that lies there.
struct Neighbor {
  int32_t body;
  int32_t image;
};

template <class V>
class Cells {
  static constexpr int kAxes = kDimensions<V>;
  static constexpr size_t kBlock = 64;  // room for a block's first spheres, usually for all

 public:
  Cells(const Box<V>& box, double diameter, double limit, int64_t bodies)
      : box_(box), next_(static_cast<size_t>(bodies), -1) {
    // A little larger, since positions and the times of crossings are rounded.
    double edge = diameter * (1 + 1e-9);
    while (!fit(edge) || double(count_.x) * count_.y * count_.z > limit) edge *= 1.05;
    for (int axis = 0; axis < kAxes; ++axis) edge_[axis] = box.extent(axis) / count_[axis];
    head_.assign(static_cast<size_t>(count_.x) * count_.y * count_.z, -1);
    for (int image = 0; image < 27; ++image) {
      const IVec3 periods = IVec3(image % 3, image / 3 % 3, image / 9) - 1;
      for (int axis = 0; axis < kAxes; ++axis) {
        shifts_[static_cast<size_t>(image)][axis] = periods[axis] * box.extent(axis);
      }
    }
  }

  const IVec3& count() const { return count_; }
  const V& edge() const { return edge_; }
  const std::vector<int32_t>& head() const { return head_; }
  const std::vector<int32_t>& next() const { return next_; }

  IVec3 cell_of(const V& p) const {
    IVec3 cell{0};
    for (int axis = 0; axis < kAxes; ++axis) {
      const double c = std::floor((p[axis] - box_.min[axis]) / edge_[axis]);
      cell[axis] = static_cast<int>(std::clamp(c, 0.0, count_[axis] - 1.0));
    }
    return cell;
  }

  /// The plane [m] at which a cell ends, towards smaller (side −1) or larger coordinates (+1).
  double face(const IVec3& cell, int axis, int side) const {
    return box_.min[axis] + (cell[axis] + (side > 0)) * edge_[axis];
  }

  /// Whether a cell ends at the domain's border there.
  bool is_border(const IVec3& cell, int axis, int side) const {
    return cell[axis] == (side > 0 ? count_[axis] - 1 : 0);
  }

  void link(int body, const IVec3& cell) {
    int32_t& head = head_[index(cell)];
    next_[static_cast<size_t>(body)] = head;
    head = body;
  }

  void unlink(int body, const IVec3& cell) {
    int32_t* link = &head_[index(cell)];
    while (*link != body) link = &next_[static_cast<size_t>(*link)];
    *link = next_[static_cast<size_t>(body)];
  }

  /// Collects all spheres of a block, or a part of it: the first of each cell, then for each collected sphere the next
  /// of its cell list. So all cell lists are walked at the same time, without waiting for the memory of one, and
  /// without branches that depend on their lengths.
  void gather(const IVec3& cell, BlockPart part, std::vector<Neighbor>& neighbors) const {
    neighbors.resize(kBlock);
    size_t count = gather_first(cell, part, neighbors.data());
    for (size_t k = 0; k < count; ++k) {
      if (count == neighbors.size()) neighbors.resize(2 * count);
      const int32_t next = next_[static_cast<size_t>(neighbors[k].body)];
      neighbors[count] = {next, neighbors[k].image};
      count += next >= 0;
    }
    neighbors.resize(count);
  }

  /// Prefetches the heads that gather() will read.
  void prefetch_heads(const IVec3& cell, BlockPart part) const {
    const Steps ys = steps(cell, 1, part), zs = kAxes == 3 ? steps(cell, 2, part) : Steps{};
    for (int z = 0; z < zs.count; ++z) {
      for (int y = 0; y < ys.count; ++y) __builtin_prefetch(&head_[index({cell.x, ys.cell[y], zs.cell[z]})]);
    }
  }

  /// Prefetches what follows the first sphere of each cell, and calls visit(body) for the first.
  template <class Visit>
  void prefetch_firsts(const IVec3& cell, BlockPart part, Visit&& visit) const {
    Neighbor firsts[27];
    const size_t count = gather_first(cell, part, firsts);
    for (size_t k = 0; k < count; ++k) {
      __builtin_prefetch(&next_[static_cast<size_t>(firsts[k].body)]);
      visit(firsts[k].body);
    }
  }

  /// The displacement from a neighbour's stored position to that of its image [m].
  const V& shift(const Neighbor& neighbor) const { return shifts_[static_cast<size_t>(neighbor.image)]; }

 private:
  /// The cells of a block along one axis, and whether they lie in the image before the domain (0), in the domain (1),
  /// or in the image after it (2).
  struct Steps {
    int count = 1;
    std::array<int, 3> cell{0, 0, 0};
    std::array<int, 3> image{1, 1, 1};
  };

  size_t gather_first(const IVec3& cell, BlockPart part, Neighbor* neighbors) const {
    const Steps xs = steps(cell, 0, part), ys = steps(cell, 1, part);
    const Steps zs = kAxes == 3 ? steps(cell, 2, part) : Steps{};
    size_t count = 0;
    for (int z = 0; z < zs.count; ++z) {
      for (int y = 0; y < ys.count; ++y) {
        const int32_t* row = head_.data() + index({0, ys.cell[y], zs.cell[z]});
        const int image = 9 * zs.image[z] + 3 * ys.image[y];
        for (int x = 0; x < xs.count; ++x) {
          neighbors[count] = {row[xs.cell[x]], image + xs.image[x]};
          count += neighbors[count].body >= 0;
        }
      }
    }
    return count;
  }

  Steps steps(const IVec3& cell, int axis, BlockPart part) const {
    const int first = part.axis == axis ? part.side : -1, last = part.axis == axis ? part.side : 1;
    Steps result;
    result.count = 0;
    for (int offset = first; offset <= last; ++offset) {
      const int c = cell[axis] + offset;
      const bool is_inside = c >= 0 && c < count_[axis];
      if (!is_inside && !box_.is_periodic()) continue;
      result.cell[result.count] = is_inside ? c : c - offset * count_[axis];
      result.image[result.count++] = is_inside ? 1 : 1 + offset;
    }
    return result;
  }

  /// Sets count_ to as many cells of at least this edge as fit; false if there are too many to count.
  bool fit(double edge) {
    for (int axis = 0; axis < kAxes; ++axis) {
      const double cells = std::floor(box_.extent(axis) / edge);
      if (cells > 1e9) return false;
      count_[axis] = std::max(1, static_cast<int>(cells));
    }
    return true;
  }

  size_t index(const IVec3& cell) const {
    return (static_cast<size_t>(cell.z) * count_.y + cell.y) * count_.x + cell.x;
  }

  Box<V> box_;
  V edge_{};                    // [m]
  IVec3 count_{1};              // cells along each axis; z is 1 in planar scenes
  std::array<V, 27> shifts_{};  // [m] by image: 9·z + 3·y + x, each 0, 1 or 2 for −1, 0 or +1 period
  std::vector<int32_t> head_;   // per cell: the sphere linked last, or −1
  std::vector<int32_t> next_;   // per sphere: the one linked before it in the same cell, or −1
};

}  // namespace ballpit
