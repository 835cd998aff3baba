// SPDX-License-Identifier: MIT
// The neighbours that hide most of the sky from each sphere, for the ambient occlusion of a picture.
//
//        ____
//       ( j  )   at the nearest point of sphere i, sphere j hides the share (r_j / (d − r_i))² of the sky;
//        ‾‾‾‾    d: from centre to centre
//     (  i   )   only spheres with d < 1.5 (r_i + r_j) are looked at
//
// The broad phase finds them: a sorted grid, among spheres of one and a half times their radius. The result depends on
// nothing but the positions, so that pictures can be repeated. Images across a periodic border are not drawn there, so
// they hide nothing. Cost: that of a search for contacts among 3.4 times as many neighbours.
#pragma once

#include <cmath>

#include "narrow_phase/collider.h"

namespace ballpit {

/// Kernel: the strongest occluders of the body in a slot, the strongest first; equal ones by id.
template <class V>
struct StrongestOccluders {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  ContactsView<V> near;
  Span<const int> id_at;
  Span<Occluder> occluder;  // by id

  HOST_DEVICE void operator()(int slot) const {
    Real share[kOccluders];  // square roots of the shares
    int found[kOccluders];  // slots
    for (int k = 0; k < kOccluders; ++k) share[k] = 0, found[k] = -1;
    const Real own = bodies.radius[slot];
    near.for_each_of(slot, [&](int, int other, int) {
      const V way = bodies.position[other] - bodies.position[slot];
      const Real radius = bodies.radius[other], distance = std::sqrt(dot(way, way));
      if (!(distance < Real(kOcclusionReach) * (own + radius))) return;
      const Real gap = distance - own;
      int next = other;
      Real more = radius / (gap > radius ? gap : radius);
      for (int k = 0; k < kOccluders && next >= 0; ++k) {  // insertion; of equal ones, the lower id comes first
        if (share[k] > more || (share[k] == more && id_of(found[k]) < id_of(next))) continue;
        const Real pushed = share[k];
        const int pushed_slot = found[k];
        share[k] = more, found[k] = next;
        more = pushed, next = pushed_slot;
      }
    });
    for (int k = 0; k < kOccluders; ++k) occluder[int64_t(id_of(slot)) * kOccluders + k] = seen_from(slot, found[k]);
  }

 private:
  HOST_DEVICE int id_of(int slot) const { return id_at.empty() ? slot : id_at[slot]; }

  HOST_DEVICE Occluder seen_from(int slot, int other) const {
    if (other < 0) return {};
    return {Vec3(widen(bodies.position[other] - bodies.position[slot])), float(bodies.radius[other])};
  }
};

template <class V, class Exec>
class OccluderSearch {
  using Real = Scalar<V>;

 public:
  /// Writes kOccluders for each body. `radii`: one for all or one each, by id; of a world they never change.
  /// `id_at`: the body in each slot; empty if they are in order.
  void find(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, const std::vector<Real>& radii,
            Span<const int> id_at, Span<Occluder> occluder) {
    if (bodies.size() == 0) return;
    const StageTimes times = exec.stage_times();
    const Span<const Real> span(radii.data(), static_cast<int64_t>(radii.size()));
    auto parameters = broad_phase_parameters<V>(Settings{}, box, span, bodies.size());
    parameters.box.boundary = Boundary::walls;
    for (SizeClass<V>& spheres : parameters.classes) spheres.largest *= Real(kOcclusionReach);
    search_.plan({BroadPhase::sorted_grid, ""}, parameters, 0);
    const BodiesView<V> grown = grow_radii(exec, bodies, Real(kOcclusionReach), Real(0), grown_);
    const Span<const Pair> near = search_.pairs(exec, grown);
    lists_.link(exec, near, search_.first());
    exec.parallel_for("find occluders", bodies.size(),
                      StrongestOccluders<V>{bodies, lists_.view(), id_at, occluder});
    exec.stage_times() = times;
  }

 private:
  Collider<V, Exec> search_;
  ContactList<V, Exec> lists_;
  typename Exec::template Buffer<Real> grown_;
};

}  // namespace ballpit
