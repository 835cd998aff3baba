// SPDX-License-Identifier: MIT
// The impulse response's contacts solved all at once, from the same velocities (Jacobi), each with its part of the masses.
// One launch an iteration, and bodies gather: no two threads write to one. Its sibling is impulse_gauss_seidel.h.
#pragma once

#include "simulate/response/impulse_law.h"

namespace ballpit {

/// Kernel: one Jacobi iteration for body i; reads the velocities before it, writes those after.
template <class V>
struct ResolveVelocity {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const ContactConstraint<V>> constraints;
  Span<const V> velocity;
  Span<V> out;

  HOST_DEVICE void operator()(int i) const {
    const V own = velocity[i];
    if (view.share[i] == 0) {
      out[i] = own;
      return;
    }
    V impulse{};
    view.contacts.for_each_of(i, [&](int c, int other, int side) {
      const ContactConstraint<V>& contact = constraints[c];
      const Real parting = dot(velocity[other] - own, contact.normal) * Real(side);
      const Real missing = contact.wanted - parting;
      impulse -= contact.normal * (Real(side) * contact.mass * (missing > 0 ? missing : Real(0)));
    });
    V change = impulse * view.bodies.inverse_mass[i];
    view.for_each_wall(i, [&](int axis, int side, Real overlap) {
      const Real missing = view.missing_at_wall(i, own, axis, side, overlap);
      if (missing > 0) change[axis] -= Real(side) * missing / view.share[i];
    });
    out[i] = own + change;
  }
};

/// Kernel: what contact c exchanges in the iteration to come, for a tally.
template <class V>
struct NoteJacobiImpulse {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const ContactConstraint<V>> constraints;
  Span<const V> velocity;
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int c) const {
    const Pair pair = view.contacts.pairs[c];
    const ContactConstraint<V>& contact = constraints[c];
    const Real missing = contact.wanted - dot(velocity[pair.j] - velocity[pair.i], contact.normal);
    if (missing > 0) notes.contact[c] += contact.mass * missing;
  }
};

/// Kernel: what body i gives the floor in the iteration to come.
template <class V>
struct NoteJacobiFloor {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const V> velocity;
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int i) const {
    view.for_each_wall(i, [&](int axis, int side, Real overlap) {
      const Real missing = view.missing_at_wall(i, velocity[i], axis, side, overlap);
      if (axis == 1 && side < 0 && missing > 0)
        notes.floor[i] += missing / (view.share[i] * view.bodies.inverse_mass[i]);
    });
  }
};

}  // namespace ballpit
