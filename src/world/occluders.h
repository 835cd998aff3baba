// SPDX-License-Identifier: MIT
// The neighbours that hide the sky from each sphere, for the ambient occlusion of a picture.
//
//        ____
//       ( j  )   at the nearest point of sphere i, sphere j hides the share s = (r_j / (d − r_i))² of the sky;
//        ‾‾‾‾    d: from centre to centre, u: the direction
//     (  i   )   only spheres with d < 1.5 (r_i + r_j) are looked at
//
// The four with the largest s are kept with their places. All others together hide about Σ s (0.1 + 0.25 u·n) at a
// normal n: fitted to a settled bed of 1 000 equal spheres, at the points that a viewer sees.
//
// The broad phase finds them: a sorted grid, among spheres of one and a half times their radius. The result depends on
// nothing but the positions, so that pictures can be repeated. Images across a periodic border are not drawn there, so
// they hide nothing. Cost: that of a search for contacts among 3.4 times as many neighbours.
#pragma once

#include <cmath>

#include "narrow_phase/collider.h"

namespace ballpit {

/// Kernel: what hides the sky from the body in a slot. Of equally strong occluders, the one of the lower id comes first.
template <class V>
struct FindOccluders {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  ContactsView<V> near;
  Span<const int> id_at;
  Span<Occluders> occluders;  // by id

  HOST_DEVICE void operator()(int slot) const {
    Real share[kOccluders];
    int found[kOccluders];  // slots
    for (int k = 0; k < kOccluders; ++k) share[k] = 0, found[k] = -1;
    near.for_each_of(slot, [&](int, int other, int) {
      int next = other;
      Real more = share_of(slot, other);
      if (more == 0) return;
      for (int k = 0; k < kOccluders && next >= 0; ++k) {  // insertion; of equal ones, the lower id comes first
        if (share[k] > more || (share[k] == more && id_of(found[k]) < id_of(next))) continue;
        const Real pushed = share[k];
        const int pushed_slot = found[k];
        share[k] = more, found[k] = next;
        more = pushed, next = pushed_slot;
      }
    });
    Occluders result;
    for (int k = 0; k < kOccluders; ++k) result.strongest[k] = seen_from(slot, found[k]);
    near.for_each_of(slot, [&](int, int other, int) {
      for (const int strong : found) {
        if (strong == other) return;
      }
      const Vec3 way = way_to(other, slot);
      const float length = std::sqrt(dot(way, way)), sum = float(bodies.radius[slot]) + float(bodies.radius[other]);
      const float fades = (kOcclusionReach - length / sum) / (kOcclusionReach - kOcclusionFades);
      const float hidden = float(share_of(slot, other)) * (fades < 1 ? fades : 1);
      if (!(hidden > 0)) return;
      result.others += kMean * hidden;
      result.others_by_normal += kByNormal * hidden / length * way;
    });
    occluders[id_of(slot)] = result;
  }

 private:
  static constexpr float kMean = 0.1f, kByNormal = 0.25f;

  /// s of sphere `other`, seen from `slot`; 0 beyond the reach.
  HOST_DEVICE Real share_of(int slot, int other) const {
    const V way = bodies.position[other] - bodies.position[slot];
    const Real own = bodies.radius[slot], radius = bodies.radius[other], distance = std::sqrt(dot(way, way));
    if (!(distance < Real(kOcclusionReach) * (own + radius))) return 0;
    const Real gap = distance - own, part = radius / (gap > radius ? gap : radius);
    return part * part;
  }

  HOST_DEVICE int id_of(int slot) const { return id_at.empty() ? slot : id_at[slot]; }

  HOST_DEVICE Occluder seen_from(int slot, int other) const {
    if (other < 0) return {};
    return {way_to(other, slot), float(bodies.radius[other])};
  }

  HOST_DEVICE Vec3 way_to(int other, int slot) const {
    Vec3 way(0.0f);
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      way[axis] = float(bodies.position[other][axis] - bodies.position[slot][axis]);
    }
    return way;
  }
};

template <class V, class Exec>
class OccluderSearch {
  using Real = Scalar<V>;

 public:
  /// Writes them for each body. `radii()`: one for all or one each, by id; of a world they never change, so it is called
  /// once. `id_at`: the body in each slot; empty if they are in order.
  template <class Radii>
  void find(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, const Radii& radii, Span<const int> id_at,
            Span<Occluders> occluders) {
    if (bodies.size() == 0) return;
    const StageTimes times = exec.stage_times();
    if (planned_for_ != bodies.size()) plan(box, radii(), bodies.size());
    search_.plan({BroadPhase::sorted_grid, ""}, parameters_, 0);
    const BodiesView<V> grown = grow_radii(exec, bodies, Real(kOcclusionReach), Real(0), grown_);
    search_.pairs(exec, grown);
    lists_.link(exec, search_.rows());
    exec.parallel_for("find occluders", bodies.size(), FindOccluders<V>{bodies, lists_.view(), id_at, occluders});
    exec.stage_times() = times;
  }

 private:
  void plan(const Box<V>& box, const std::vector<Real>& radii, int64_t count) {
    planned_for_ = count;
    const Span<const Real> span(radii.data(), static_cast<int64_t>(radii.size()));
    parameters_ = broad_phase_parameters<V>(Settings{}, box, span, count);
    parameters_.box.boundary = Boundary::walls;
    for (SizeClass<V>& spheres : parameters_.classes) spheres.largest *= Real(kOcclusionReach);
  }

  int64_t planned_for_ = -1;  // spheres
  BroadPhaseParameters<V> parameters_;
  Collider<V, Exec> search_;
  ContactList<V, Exec> lists_;
  typename Exec::template Buffer<Real> grown_;
};

}  // namespace ballpit
