// SPDX-License-Identifier: MIT
// What every broad phase is made from, and the contract that all keep. A broad phase is a class with
//
//     plan(parameters)         starts anew for others, in the memory that it holds
//     prepare(exec, bodies)    builds its structure for frozen positions
//     candidates()             a kernel's view of it, of one of two kinds:
//       lists                  for_each(i, visit) calls visit(j) for candidates j > i of body i, until visit returns false
//       ranges                 slots(), copies of the bodies in an order of its own, and for_each_range(slot, visit),
//                              which calls visit(range) for ranges of slots; thread t of threads() works for slot_of(t);
//                              on the CPU for_each_range_of(from, to, visit) calls visit(slot, range) for slots
//                              from … to − 1, in an order that suits its caches
//     inspect(exec)            its grids for the audience, where it has some
//     axis(), endpoints(exec, bodies)
//                              what sort-and-sweep sorts, for the audience
//     walks(exec)              what each thread walks, where that is not its candidates
//     bytes()                  memory held
//
// Over all bodies each pair comes at most once, and every pair in contact comes.
#pragma once

#include <optional>
#include <vector>

#include "bodies/box.h"
#include "core/span.h"
#include "methods/choices.h"

namespace ballpit {

/// Spheres of like size: at most the largest's radius, more than the next class's.
template <class V>
struct SizeClass {
  Scalar<V> largest = 0;  ///< [m]
  int64_t count = 0;
};

inline constexpr int kLargestAxis = -1;  ///< the axis along which the positions vary most
inline constexpr int kMaxSizeClasses = 8;

template <class V>
struct BroadPhaseParameters {
  Box<V> box;
  int64_t count = 0;
  std::vector<SizeClass<V>> classes;  ///< largest first; at least one, unless count is 0
  std::optional<double> cell_size;    ///< in units of 2·r_max; chosen by the method where empty
  CellTable table = CellTable::automatic;
  double occupied_volume = 0;  ///< [m³, in planar scenes m²] where the spheres are, if they stay there; 0: not known
  int axis = kLargestAxis;     ///< of the sweep

  Scalar<V> largest_radius() const { return classes.empty() ? Scalar<V>(0) : classes.front().largest; }
};

/// How much of the box the points share among them [m³, in planar scenes m²]: all of it where they are spread evenly,
/// less where they gather. Estimated from a sample, by the probability that two of it lie in one of many equal cells.
template <class V>
double occupied_volume(const Box<V>& box, Span<const Vec3> position);

/// The size classes of these radii [m], one for all or one each: equal steps of about 2.5; what is too small for
/// kMaxSizeClasses such steps belongs to the last. Classes without spheres are left out.
template <class V>
std::vector<SizeClass<V>> size_classes(Span<const Scalar<V>> radius, int64_t count);

}  // namespace ballpit
