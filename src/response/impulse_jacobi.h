// SPDX-License-Identifier: MIT
// Solves all contacts of the impulse response at once from the same velocities (Jacobi), each with its part of the
// masses. One launch per iteration. Bodies gather: both bodies of a contact compute its impulse, so no two threads
// write to the same memory. Its sibling is impulse_gauss_seidel.h.
#pragma once

#include "core/span.h"
#include "response/impulse_law.h"

namespace ballpit {

/// Kernel: one Jacobi iteration for body i; reads the velocities and sums of the last iteration, writes new ones.
template <class V>
struct ResolveVelocity {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const ContactConstraint<V>> constraints;
  Span<const V> velocity;
  Span<const Real> exchanged;  ///< total impulse of each contact so far [kg·m/s]
  Span<V> next_velocity;
  Span<Real> next_exchanged;
  WallSums<V> walls;
  bool is_first;  ///< iteration: sums count as 0; the memory is not initialized

  HOST_DEVICE void operator()(int i) const {
    const V own = velocity[i];
    const Real inverse_mass = view.bodies.inverse_mass[i];
    if (view.share[i] == 0) {
      next_velocity[i] = own;
      return;
    }
    V impulse{};
    view.contacts.for_each_of(i, [&](int c, int other, int side) {
      const ContactConstraint<V>& contact = constraints[c];
      const Real parting = dot(velocity[other] - own, contact.normal) * Real(side);
      Real sum = is_first ? Real(0) : exchanged[c];
      impulse -= contact.normal * (Real(side) * add_unless_pulling(sum, contact.mass * (contact.wanted - parting)));
      if (side > 0) next_exchanged[c] = sum;
    });
    V at_walls = own;  // velocity of the one part that meets all walls, one after the other
    const Real part = view.share[i] * inverse_mass;
    view.for_each_wall(i, [&](int axis, int side, Real overlap) {
      Real& sum = walls.at(i, axis, side);
      if (is_first) sum = 0;
      const Real missing = view.missing_at_wall(i, at_walls, axis, side, overlap);
      const Real change = Real(side) * add_unless_pulling(sum, missing / part);
      impulse[axis] -= change;
      at_walls[axis] -= change * part;
    });
    next_velocity[i] = own + impulse * inverse_mass;
  }
};

}  // namespace ballpit
