// SPDX-License-Identifier: MIT
// Solves the contacts of the impulse response one after another (Gauss–Seidel), each with the full masses and the
// velocities that the ones before have left: walls first, then contacts colour by colour. Cost: a launch for each
// colour and iteration; it converges faster than its sibling impulse_jacobi.h. Source: Catto, "Iterative Dynamics with
// Temporal Coherence" (2005); for colours see contact_colours.h.
#pragma once

#include "bodies/pair.h"
#include "core/span.h"
#include "response/impulse_law.h"

namespace ballpit {

/// Kernel: solves the walls of body i.
template <class V>
struct SolveWalls {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<V> velocity;
  WallSums<V> walls;

  HOST_DEVICE void operator()(int i) const {
    const Real inverse_mass = view.bodies.inverse_mass[i];
    V own = velocity[i];
    view.for_each_wall(i, [&](int axis, int side, Real overlap) {
      Real& sum = walls.at(i, axis, side);
      const Real change = add_unless_pulling(sum, view.missing_at_wall(i, own, axis, side, overlap) / inverse_mass);
      own[axis] -= Real(side) * change * inverse_mass;
    });
    velocity[i] = own;
  }
};

/// Kernel: solves the k-th contact of a colour. `exchanged` is each contact's total impulse [kg·m/s].
template <class V>
struct SolveContact {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const ContactConstraint<V>> constraints;
  Span<const int> colour;
  Span<V> velocity;
  Span<Real> exchanged;

  HOST_DEVICE void operator()(int k) const {
    const int c = colour[k];
    const Pair pair = view.contacts.pairs[c];
    const V normal = constraints[c].normal;
    const Real wi = view.bodies.inverse_mass[pair.i], wj = view.bodies.inverse_mass[pair.j];
    const Real missing = constraints[c].wanted - dot(velocity[pair.j] - velocity[pair.i], normal);
    const V impulse = normal * add_unless_pulling(exchanged[c], missing / (wi + wj));
    velocity[pair.i] -= impulse * wi;
    velocity[pair.j] += impulse * wj;
  }
};

}  // namespace ballpit
