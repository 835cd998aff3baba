// SPDX-License-Identifier: MIT
// The parameters, the choice (--broadphase auto) and the interface of all broad phases. A broad phase is a class with
//
//     plan(parameters)         resets it for other parameters; keeps its memory
//     prepare(exec, bodies)    builds its data structure for the present positions
//     candidates()             a view of it for kernels, of one of two kinds:
//       lists                  for_each(i, visit) calls visit(j) for candidates j > i of body i; stops at false
//       ranges                 slots(), copies of the bodies in an order of its own, and for_each_range(slot, visit),
//                              which calls visit(range) for ranges of slots. Thread t of threads() works for
//                              slot_of(t), or does nothing if that is −1. On the CPU for_each_range_of(from, to, visit)
//                              calls visit(slot, range) for slots from … to − 1, in an order that suits the caches
//     inspect(exec)            its grids for the audience, if it has some
//     axis(), endpoints(exec, bodies)
//                              the axis and the sorted list of sort-and-sweep, for the audience
//     bytes()                  memory held
//
// Among the candidates of all bodies, each pair is at most once, and every pair in contact is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bodies/box.h"
#include "core/span.h"
#include "methods/settings.h"

namespace ballpit {

/// Spheres of similar size: radii up to `largest`, above the largest of the next class.
template <class V>
struct SizeClass {
  Scalar<V> largest = 0;  ///< [m]
  int64_t count = 0;
};

inline constexpr int kAutoAxis = -1;  ///< the axis along which the positions vary most
inline constexpr int kMaxSizeClasses = 8;

template <class V>
struct BroadPhaseParameters {
  Box<V> box;
  int64_t count = 0;
  std::vector<SizeClass<V>> classes;  ///< largest first; at least one, unless count is 0
  std::optional<double> cell_size;    ///< in units of 2·r_max; empty: the method chooses
  CellTable table = CellTable::automatic;
  double occupied_volume = 0;  ///< [m³, in planar scenes m²] see occupied_volume(); 0: unknown
  int axis = kAutoAxis;        ///< of the sweep

  Scalar<V> largest_radius() const { return classes.empty() ? Scalar<V>(0) : classes.front().largest; }
};

/// The part of the box in which the points lie [m³, in planar scenes m²]: the whole box if they are spread evenly, less
/// if they form clusters. Estimated from a sample, by the probability that two of its points lie in the same one of
/// many equal cells.
template <class V>
double occupied_volume(const Box<V>& box, Span<const Vec3> position);

/// The size classes of these radii [m], one for all or one each, in equal steps of about 2.5. Radii too small for
/// kMaxSizeClasses such steps belong to the last class. Empty classes are left out.
template <class V>
std::vector<SizeClass<V>> size_classes(Span<const Scalar<V>> radius, int64_t count);

/// The parameters for a box, settings and radii (one for all, or one each).
template <class V>
BroadPhaseParameters<V> broad_phase_parameters(const Settings& settings, const Box<V>& box,
                                               Span<const Scalar<V>> radius, int64_t count);

struct BroadPhaseChoice {
  BroadPhase method;  ///< never automatic
  std::string reason;  ///< "predicted for 20000 spheres, ms on one core: sorted-grid 1.3, …"; empty if it was asked for
};

/// The broad phase that `settings` ask for; for "auto" the one predicted to be fastest on spheres spread evenly.
template <class V>
BroadPhaseChoice choose_broad_phase(const Settings& settings, const BroadPhaseParameters<V>& parameters);

}  // namespace ballpit
