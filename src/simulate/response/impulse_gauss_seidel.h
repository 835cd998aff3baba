// SPDX-License-Identifier: MIT
// The impulse response's contacts solved one after another, each with the whole masses and from what those before have left
// (Gauss–Seidel): walls first, then the contacts colour by colour. A launch for each colour and iteration; converges faster
// than its sibling impulse_jacobi.h. What a contact has exchanged is summed up, and the sum never pulls, so an iteration may
// take back what an earlier one gave too much.
// Source: Catto, "Iterative Dynamics with Temporal Coherence" (2005); for colours see contact_colours.h.
#pragma once

#include "simulate/response/impulse_law.h"

namespace ballpit {

/// Kernel: the walls of body i. `low` and `high` sum up what those at min and max gave, along each axis [kg·m/s].
template <class V>
struct SolveWalls {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<V> velocity, low, high;

  HOST_DEVICE void operator()(int i) const {
    const Real inverse_mass = view.bodies.inverse_mass[i];
    V own = velocity[i];
    view.for_each_wall(i, [&](int axis, int side, Real overlap) {
      Real& sum = side < 0 ? low[i][axis] : high[i][axis];
      const Real asked = sum + view.missing_at_wall(i, own, axis, side, overlap) / inverse_mass;
      const Real next = asked > 0 ? asked : Real(0);
      own[axis] -= Real(side) * (next - sum) * inverse_mass;
      sum = next;
    });
    velocity[i] = own;
  }
};

/// Kernel: the k-th contact of a colour. `exchanged` sums up what each contact gave [kg·m/s].
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
    const Real asked = exchanged[c] + missing / (wi + wj);
    const Real next = asked > 0 ? asked : Real(0);
    const V impulse = normal * (next - exchanged[c]);
    exchanged[c] = next;
    velocity[pair.i] -= impulse * wi;
    velocity[pair.j] += impulse * wj;
  }
};

/// Kernel: adds what contact c has exchanged to the notes of a tally.
template <class Real>
struct NoteSum {
  Span<const Real> exchanged;
  Span<Real> notes;
  HOST_DEVICE void operator()(int c) const { notes[c] += exchanged[c]; }
};

/// Kernel: the same for what body i gave the floor.
template <class V>
struct NoteFloorSum {
  Span<const V> low;
  Span<Scalar<V>> notes;
  HOST_DEVICE void operator()(int i) const { notes[i] += low[i][1]; }
};

}  // namespace ballpit
