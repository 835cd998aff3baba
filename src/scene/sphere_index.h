// SPDX-License-Identifier: MIT
// Finds the spheres that overlap a given one, for filling and checking scenes. Host only.
//
//   Levels by size: level e holds diameters of 2^e up to 2^(e+1); its cells are 2^(e+1) wide. The grid has no bounds.
//
//        level −3                     level −5
//     +-------+-------+            +-+-+-+-+-+-+-+-+
//     |  (0)  |       |            | | |0| | | | | |
//     |       |  (1)  |            +-+-+-+-+-+-+-+-+
//     +-------+-------+            | | | | |12 | | |
//                                  +-+-+-+-+-+-+-+-+
//
//   cell (x, y, z) → bucket    head   [  2 | −1 |  1 | … ]    at least as many buckets as spheres
//                                        |
//   spheres as inserted        sphere [ s0 | s1 | s2 ]
//                              next   [ −1 | −1 |  0 ]
//
// A query visits the cells within its reach, level by level, or all spheres of a level if there are fewer of them than cells
// (a big sphere among small ones). In a periodic domain it is repeated for each image of the query that reaches across an edge.
// Cost: insert O(1) amortised; query O(levels + cells in reach + spheres in them).
// Source: Eitz and Lixu, Hierarchical Spatial Hashing for Real-time Collision Detection, SMI 2007.
#pragma once

#include "scene/scene.h"

namespace ballpit {

/// The spheres from `first` to `end` − 1, the largest first; equal ones in their order.
std::vector<int32_t> by_descending_radius(const std::vector<double>& radius, int64_t first, int64_t end);

class SphereIndex {
 public:
  struct Sphere {
    Vec3d position;  ///< [m]
    double radius;   ///< [m]
    int32_t id;
    int32_t next;  ///< in the same bucket, −1 at its end
  };

  explicit SphereIndex(const Domain& domain) : domain_(domain) {}

  /// Adds a sphere. In a periodic domain its centre must lie in it.
  void insert(int32_t id, const Vec3d& position, double radius);

  /// Calls `visit(sphere, distance²)` for each stored sphere that overlaps the query when both radii are enlarged by `gap` (a
  /// fraction), once for each of its images. Stops and returns true when `visit` returns true.
  template <class Visit>
  bool visit_near(const Vec3d& position, double radius, double gap, Visit visit) const;

  /// Whether there is room for a sphere, at least `gap` · (sum of radii) from all others.
  bool is_free(const Vec3d& position, double radius, double gap) const {
    return !visit_near(position, radius, gap, [](const Sphere&, double) { return true; });
  }

  int64_t size() const { return size_; }

 private:
  struct Level {
    int exponent = 0;
    double cell = 1.0;     // [m] edge, a power of two, so position / cell is exact
    double largest = 0.0;  // [m] radius
    std::vector<Sphere> spheres;
    std::vector<int32_t> head;  // size a power of two
  };

  /// The lowest and highest cell that a query reaches, and the number of cells.
  struct CellRange {
    Vec3d low;
    Vec3d high;
    double count;
  };

  Level& level_of(double radius);
  CellRange cells_in_reach(const Level& level, const Vec3d& position, double reach) const;
  static size_t bucket(const Level& level, const Vec3d& cell);
  static void grow(Level& level);

  /// `at` in units of cells. Compares instead of subtracting: −1e-20 is in cell −1, but −1e-20 + 1 rounds to 1.
  static bool is_in_cell(const Vec3d& at, const Vec3d& cell) {
    return at.x >= cell.x && at.x < cell.x + 1.0 && at.y >= cell.y && at.y < cell.y + 1.0 && at.z >= cell.z &&
           at.z < cell.z + 1.0;
  }

  /// Computes the images of `position` within `reach` of the domain, itself first; returns their number.
  int images(const Vec3d& position, double reach, Vec3d (&image)[27]) const;

  template <class Visit>
  static bool visit_level(const Level& level, const CellRange& range, const Visit& visit);

  Domain domain_;
  std::vector<Level> levels_;
  double largest_ = 0.0;
  int64_t size_ = 0;
};

template <class Visit>
bool SphereIndex::visit_near(const Vec3d& position, double radius, double gap, Visit visit) const {
  Vec3d image[27];
  const int image_count = images(position, (radius + largest_) * (1.0 + gap), image);
  for (int k = 0; k < image_count; ++k) {
    const auto visit_if_near = [&](const Sphere& sphere) {
      const Vec3d d = sphere.position - image[k];
      const double distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
      const double touching = (radius + sphere.radius) * (1.0 + gap);
      return distance2 < touching * touching && visit(sphere, distance2);
    };
    for (const Level& level : levels_) {
      const double reach = (radius + level.largest) * (1.0 + gap);
      if (visit_level(level, cells_in_reach(level, image[k], reach), visit_if_near)) return true;
    }
  }
  return false;
}

template <class Visit>
bool SphereIndex::visit_level(const Level& level, const CellRange& range, const Visit& visit) {
  if (!(range.count < static_cast<double>(level.spheres.size()))) {
    for (const Sphere& sphere : level.spheres) {
      if (visit(sphere)) return true;
    }
    return false;
  }
  const double scale = 1.0 / level.cell;
  Vec3d cell;
  for (cell.z = range.low.z; cell.z <= range.high.z; cell.z += 1.0) {
    for (cell.y = range.low.y; cell.y <= range.high.y; cell.y += 1.0) {
      for (cell.x = range.low.x; cell.x <= range.high.x; cell.x += 1.0) {
        for (int32_t i = level.head[bucket(level, cell)]; i >= 0;) {
          const Sphere& sphere = level.spheres[static_cast<size_t>(i)];
          i = sphere.next;
          // Cells share buckets, so check the cell: each sphere is then visited once.
          if (is_in_cell(sphere.position * scale, cell) && visit(sphere)) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace ballpit
