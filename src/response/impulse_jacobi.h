// SPDX-License-Identifier: MIT
// The impulse response's contacts solved all at once, from the same velocities (Jacobi), each with its part of the masses.
// One launch an iteration, and bodies gather: both bodies of a contact compute what it exchanges, and no two threads write to
// one place. Its sibling is impulse_gauss_seidel.h.
#pragma once

#include "core/span.h"
#include "response/impulse_law.h"

namespace ballpit {

/// Kernel: one Jacobi iteration for body i; reads velocities and sums before it, writes those after.
template <class V>
struct ResolveVelocity {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const ContactConstraint<V>> constraints;
  Span<const V> velocity;
  Span<const Real> exchanged;  ///< by each contact so far [kg·m/s]
  Span<V> next_velocity;
  Span<Real> next_exchanged;
  WallSums<V> walls;
  bool is_first;  ///< iteration: sums are 0, whatever memory holds

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
    V at_walls = own;  // of the one part that meets all walls, one after the other
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
