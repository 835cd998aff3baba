// SPDX-License-Identifier: MIT
// The grids of a sorted grid: one for each size class, largest spheres first, with their buckets one after another in
// the same array.
//
//     radii      0.5 0.4   │   0.1 0.1 0.08
//     class         0      │        1
//     buckets    0 … 63    │   64 … 4159         first_bucket = {0, 64}
//
// A class spans a factor of about 2.5 (size_classes() of parameters.h). Source: Ericson, "Real-Time Collision
// Detection" (2005), section 7.2.
#pragma once

#include "bodies/slots.h"
#include "broad_phase/grid.h"
#include "broad_phase/parameters.h"
#include "core/span.h"

namespace ballpit {

template <class V>
struct ClassGrids {
  using Real = Scalar<V>;
  int count = 0;
  bool is_block = false;               ///< searches the 3 × 3 (× 3) block, whatever a sphere reaches (--cell-size)
  Real guard = 0;                      ///< bound on the rounding error of a distance [m]
  Real largest[kMaxSizeClasses] = {};  ///< [m] radius, descending
  V diameter[kMaxSizeClasses] = {};    ///< [cells] of the largest sphere, rounding error included
  int first_bucket[kMaxSizeClasses] = {};  ///< of each class
  Grid<V> grid[kMaxSizeClasses] = {};

  HOST_DEVICE int class_of(Real radius) const {
    int k = 0;
    while (k + 1 < count && radius <= largest[k + 1]) ++k;
    return k;
  }

  /// The offsets of class k: bucket b of its grid holds slots offsets[b] … offsets[b + 1] − 1.
  HOST_DEVICE Span<const int> offsets_of(int k, Span<const int> offsets) const {
    return {offsets.data() + first_bucket[k], offsets.size() - first_bucket[k]};
  }
};

/// Key of the counting sort: the bucket of body i's cell.
template <class V>
struct BucketOfBody {
  ClassGrids<V> grids;
  Span<const V> position;
  PerBody<Scalar<V>> radius;

  HOST_DEVICE int operator()(int i) const {
    const int k = grids.count == 1 ? 0 : grids.class_of(radius[i]);
    const Grid<V>& grid = grids.grid[k];
    return grids.first_bucket[k] + grid.index(grid.cell_of(position[i]));
  }
};

/// Kernel: the tag of a slot's cell.
template <class V>
struct StoreTag {
  ClassGrids<V> grids;
  SlotsView<V> slots;
  Span<unsigned> tag;

  HOST_DEVICE void operator()(int slot) const {
    const Grid<V>& grid = grids.grid[grids.class_of(slots.radius[slot])];
    tag[slot] = grid.tag(grid.cell_of(slots.position(slot)));
  }
};

}  // namespace ballpit
