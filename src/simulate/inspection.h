// SPDX-License-Identifier: MIT
// What the simulation shows of itself: copies on the host, so that looking never changes what is looked at.
// Renderers and overlays read these; they know nothing else of the simulation.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/math.h"
#include "core/span.h"
#include "simulate/pair.h"

namespace ballpit {

/// The bodies as the vertex shader reads them: `dimensions` floats of position a body, missing coordinates are 0;
/// one radius for all, or one each.
struct BodySnapshot {
  int64_t count = 0;
  int dimensions = 3;
  std::vector<float> position;  ///< [m] count × dimensions
  std::vector<float> velocity;  ///< [m/s] count × dimensions
  std::vector<float> radius;    ///< [m] 1 or count values

  Vec3 position_of(int64_t i) const { return vector_at(position, i); }
  Vec3 velocity_of(int64_t i) const { return vector_at(velocity, i); }
  float radius_of(int64_t i) const { return radius.size() == 1 ? radius[0] : radius[static_cast<size_t>(i)]; }

 private:
  Vec3 vector_at(const std::vector<float>& values, int64_t i) const {
    const float* v = values.data() + i * dimensions;
    return {v[0], v[1], dimensions == 3 ? v[2] : 0.0f};
  }
};

/// What of the bodies never changes while a world lives, but their places and velocities do.
struct BodyShape {
  int64_t count = 0;
  int dimensions = 3;
  bool has_equal_radii = true;
  float radius = 0;    ///< [m] of all, or the largest
  float smallest = 0;  ///< [m] radius
};

/// Memory of a world's own processor that a vertex shader reads, for bodies in the order of their ids.
struct BodyTarget {
  Span<float> position;    ///< [m] count × dimensions
  Span<float> radius;      ///< [m] count values; none where all are equal
  Span<uint8_t> touching;  ///< 1 for a body in contact, else 0
};

/// Where a method keeps the bodies of its cells: in lists of its own (head and next), or sorted by cell. A hashed grid
/// has an entry for each place of its table, which cells share, instead of one for each cell.
struct CellArrays {
  bool is_sorted = false;
  bool is_hashed = false;
  std::vector<int32_t> cells;   ///< head; if sorted, where each entry's range begins, and at last where all end
  std::vector<int32_t> bodies;  ///< next; if sorted, the bodies of all ranges
};

/// A grid of cells: cell (x, y, z) has the index (z · cells.y + y) · cells.x + x, covers
/// origin + (x, y, z) ∘ edge to origin + (x+1, y+1, z+1) ∘ edge, and lists its bodies from head[index] along next[],
/// as the audience sees them: those of one cell, whatever the method keeps. In a sorted grid the last of the range
/// comes first.
struct GridInspection {
  Vec3 origin{0.0f};
  Vec3 edge{0.0f};  ///< [m] the same along every axis, unless a periodic domain stretches it to a whole number of cells
  IVec3 cells{0};   ///< z is 1 in planar scenes
  std::vector<int32_t> head;  ///< one entry per cell: its first body, or −1; empty where there are too many cells
  std::vector<int32_t> next;  ///< one entry per body: the one linked before it, or −1
  std::optional<CellArrays> arrays;  ///< the method's own; none where those are head and next

  bool is_sorted() const { return arrays && arrays->is_sorted; }
};

/// An entry of the list that sort-and-sweep sorts: where a sphere begins or ends along the axis, but for a guard against
/// rounding of about a millionth.
struct Endpoint {
  float at = 0;  ///< [m]
  int32_t body = 0;
  bool is_end = false;
};

/// What an inspection is to hold beside the number of bodies; each costs what it costs.
struct Wanted {
  bool state = true;  ///< places, velocities, radii, contacts and lists
  bool candidates = false;
  bool missed = false;     ///< brute force is the oracle: O(n²) tests
  bool endpoints = false;  ///< and the axis
  bool work = false;

  bool more_than_state() const { return candidates || missed || endpoints || work; }

  Wanted operator|(const Wanted& other) const {
    return {state || other.state, candidates || other.candidates, missed || other.missed, endpoints || other.endpoints,
            work || other.work};
  }
  bool operator==(const Wanted&) const = default;
};

struct Inspection {
  BodySnapshot bodies;
  std::vector<Pair> contacts;         ///< overlapping pairs that the method found, sorted by i, then j
  std::vector<GridInspection> grids;  ///< of the broad phase: one for each size class, or none

  // If wanted; as the method searches the present positions where there is no candidate list.
  std::vector<Pair> candidates;     ///< pairs that the broad phase gives to the narrow phase, sorted
  std::vector<Pair> missed;         ///< overlapping pairs that the method did not find, sorted
  int axis = -1;                    ///< along which sort-and-sweep sorts: 0, 1, 2; −1 for other methods
  std::vector<Endpoint> endpoints;  ///< its sorted list, by `at`
  std::vector<int> work;            ///< candidates that each thread walks over
  std::vector<int32_t> worker;      ///< the body that each thread walks for; −1 for one that has nothing to do
};

}  // namespace ballpit
