// SPDX-License-Identifier: MIT
// The cells of event-driven motion: linked lists, as in broadphase/linked_cell.h, that change one sphere at a time.
//
//     a periodic row of three cells, and what is around cell 0:
//
//         ┆ 2 − L │  0  │  1  │  2  ┆        cell 2 counts twice where there are but two: as the neighbour on the left,
//            ▲───────█─────▲                 shifted by −L, and as the one on the right
//
// The block around a cell is taken from the endless lattice of a periodic domain's images, so that one rule holds down to
// a single cell. The outermost cells of a domain with walls end at the walls; without a ceiling the uppermost reach up
// without end. Edges are at least the largest diameter, so that spheres which touch lie in neighbouring cells, and larger
// where the domain would have more cells than `limit`.
// Cost: 4 bytes a cell, 4 a sphere (Flight::next).
#pragma once

#include <array>
#include <vector>

#include "simulate/event_driven/flight.h"
#include "simulate/state.h"

namespace ballpit {

/// Which cells around a cell are visited: all, or those that lie ahead of a sphere which has entered it along an axis.
struct BlockPart {
  int axis = -1;  ///< −1: all
  int side = 0;   ///< −1 or +1
};

template <class V>
class Cells {
  static constexpr int kAxes = kDimensions<V>;

 public:
  Cells(const Box<V>& box, double diameter, double limit) : box_(box) {
    // A little larger: positions are rounded, and so are the times of crossings.
    double edge = diameter * (1 + 1e-9);
    while (!fit(edge) || double(count_.x) * count_.y * count_.z > limit) edge *= 1.05;
    for (int axis = 0; axis < kAxes; ++axis) edge_[axis] = (box.max[axis] - box.min[axis]) / count_[axis];
    head_.assign(static_cast<size_t>(count_.x) * count_.y * count_.z, -1);
  }

  const IVec3& count() const { return count_; }
  const V& edge() const { return edge_; }
  const std::vector<int32_t>& head() const { return head_; }

  IVec3 cell_of(const V& p) const {
    IVec3 cell{0};
    for (int axis = 0; axis < kAxes; ++axis) {
      const double place = std::floor((p[axis] - box_.min[axis]) / edge_[axis]);
      cell[axis] = static_cast<int>(std::clamp(place, 0.0, count_[axis] - 1.0));
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

  void link(int body, const IVec3& cell, std::vector<Flight<V>>& flights) {
    int32_t& head = head_[index(cell)];
    flights[static_cast<size_t>(body)].next = head;
    head = body;
  }

  void unlink(int body, const IVec3& cell, std::vector<Flight<V>>& flights) {
    int32_t* link = &head_[index(cell)];
    while (*link != body) link = &flights[static_cast<size_t>(*link)].next;
    *link = flights[static_cast<size_t>(body)].next;
  }

  /// Calls visit(first body, shift) for each cell of the block that holds spheres; shift [m] takes the cell to its place
  /// beside the block's centre.
  template <class Visit>
  void for_each_around(const IVec3& cell, BlockPart part, Visit&& visit) const {
    const Steps xs = steps(cell, 0, part), ys = steps(cell, 1, part);
    const Steps zs = kAxes == 3 ? steps(cell, 2, part) : Steps{1, {0}, {0}};
    V shift{};
    for (int z = 0; z < zs.count; ++z) {
      if constexpr (kAxes == 3) shift[2] = zs.shift[z];
      for (int y = 0; y < ys.count; ++y) {
        shift[1] = ys.shift[y];
        const int32_t* row = head_.data() + static_cast<size_t>(zs.cell[z] * count_.y + ys.cell[y]) * count_.x;
        for (int x = 0; x < xs.count; ++x) {
          const int32_t head = row[xs.cell[x]];
          if (head < 0) continue;
          shift[0] = xs.shift[x];
          visit(head, shift);
        }
      }
    }
  }

 private:
  /// The cells of a block along one axis.
  struct Steps {
    int count = 0;
    std::array<int, 3> cell;
    std::array<double, 3> shift;
  };

  Steps steps(const IVec3& cell, int axis, BlockPart part) const {
    const int first = part.axis == axis ? part.side : -1, last = part.axis == axis ? part.side : 1;
    Steps result;
    for (int offset = first; offset <= last; ++offset) {
      int c = cell[axis] + offset;
      double shift = 0;
      if (c < 0 || c >= count_[axis]) {
        if (!box_.is_periodic()) continue;
        c -= offset * count_[axis];
        shift = offset * (box_.max[axis] - box_.min[axis]);
      }
      result.cell[result.count] = c;
      result.shift[result.count++] = shift;
    }
    return result;
  }

  /// Chooses as many cells of at least this edge as fit; false where they cannot be counted.
  bool fit(double edge) {
    for (int axis = 0; axis < kAxes; ++axis) {
      const double cells = std::floor((box_.max[axis] - box_.min[axis]) / edge);
      if (cells > 1e9) return false;
      count_[axis] = std::max(1, static_cast<int>(cells));
    }
    return true;
  }

  size_t index(const IVec3& cell) const {
    return (static_cast<size_t>(cell.z) * count_.y + cell.y) * count_.x + cell.x;
  }

  Box<V> box_;
  V edge_{};        // [m]
  IVec3 count_{1};  // cells along each axis; z is 1 in planar scenes
  std::vector<int32_t> head_;
};

}  // namespace ballpit
