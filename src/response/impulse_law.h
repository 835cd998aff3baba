// SPDX-License-Identifier: MIT
// The law of impulse.h, for both of its solvers: the wanted speed of a contact, and how much of its overlap is removed.
#pragma once

#include "bodies/bodies_view.h"
#include "bodies/contacts.h"
#include "response/walls_view.h"

namespace ballpit {

template <class Real>
struct ImpulseParameters {
  Real restitution, wall_restitution;
  Real push = Real(0.8);    ///< fraction of the old overlap that a step pushes out by velocity …
  Real push_limit = 0;      ///< [m/s] … at most at this speed
  Real entered = 1;         ///< fraction of the entered overlap that a step removes by moving bodies
  Real correction = 0;      ///< the same for the old overlap
  Real foresight = 1;       ///< fraction of the overlap removed by the new velocity that is left to it
  Real slop = Real(0.005);  ///< overlap kept so that contacts persist: a fraction of r_i + r_j, or of r at a wall
  int iterations = 4;
  bool is_by_colour = false;  ///< Gauss–Seidel instead of Jacobi
};

/// The data of a contact that every iteration reads.
template <class V>
struct ContactConstraint {
  V normal;           ///< from i to j
  Scalar<V> wanted;   ///< wanted speed of parting [m/s]
  Scalar<V> overlap;  ///< to be removed by moving the bodies, unless their parting removes it [m]
  Scalar<V> mass;     ///< effective mass 1 / (c_i·w_i + c_j·w_j) [kg]
};

/// The data that every kernel of the impulse response reads.
template <class V>
struct ImpulseView {
  using Real = Scalar<V>;
  BodiesView<V> bodies;  ///< with the velocities before the kick
  WallsView<V> walls;
  ContactsView<V> contacts;
  Span<const Real> share;  ///< c: contacts of each body; all walls count as one
  ImpulseParameters<Real> law;
  Real dt;  ///< [s]

  /// Calls visit(axis, side, overlap) for each wall of body i.
  template <class Visit>
  HOST_DEVICE void for_each_wall(int i, Visit&& visit) const {
    walls.for_each(i, bodies.position[i], bodies.radius[i], visit);
  }

  /// False if body i touches no wall, which its share tells without its position. A GPU would need more registers to
  /// find out (eight in ResolveVelocity).
  HOST_DEVICE bool may_touch_wall(int i) const {
    return kOnDevice || share[i] != static_cast<Real>(contacts.count_of(i));
  }

  /// By how much body i, at `velocity`, must part faster from a wall [m/s]; at most 0 if it is fast enough.
  HOST_DEVICE Real missing_at_wall(int i, const V& velocity, int axis, int side, Real overlap) const {
    Real before = -Real(side) * bodies.velocity[i][axis], later = 0;
    if (walls.is_swept()) {
      const Real kick = -Real(side) * walls.sweep.kick_of(i)[axis], first = walls.sweep.first[i];
      before += kick * first;
      later = kick * (1 - first);
    }
    return wanted(law.wall_restitution, before, overlap, bodies.radius[i], later) + Real(side) * velocity[axis];
  }

  /// The speed that the rest of the step's kick adds to the parting of contact c [m/s]: 0 unless contacts are swept,
  /// and 0 between spheres that both fall.
  HOST_DEVICE Real later(int c, const Pair& pair, const V& normal) const {
    if (!walls.is_swept()) return 0;
    return dot(walls.sweep.kick_of(pair.j) - walls.sweep.kick_of(pair.i), normal) * (1 - walls.sweep.time[c]);
  }

  /// The overlap that a contact with this separation has entered during the last step [m].
  HOST_DEVICE Real entered_overlap(Real separation, Real overlap) const {
    const Real moved = separation < 0 ? -separation * dt : Real(0);
    return moved < overlap ? moved : overlap;
  }

  /// The overlap from before the last step, less the slop [m].
  HOST_DEVICE Real old_overlap(Real separation, Real overlap, Real radii) const {
    const Real old = overlap - entered_overlap(separation, overlap) - law.slop * radii;
    return old > 0 ? old : Real(0);
  }

  /// The overlap to be removed by moving the bodies [m].
  HOST_DEVICE Real removable(Real separation, Real overlap, Real radii) const {
    return law.entered * entered_overlap(separation, overlap) +
           law.correction * old_overlap(separation, overlap, radii);
  }

  /// The wanted speed of parting at the end of the step [m/s]: the larger one of the rebound by restitution, plus the
  /// kick that is added `later`, and of the speed that pushes out old overlap.
  HOST_DEVICE Real wanted(Real e, Real separation, Real overlap, Real radii, Real later) const {
    const Real rebound = separation < 0 ? later - e * separation : Real(0);
    const Real out = law.push * old_overlap(separation, overlap, radii) / dt;
    const Real limited = out < law.push_limit ? out : law.push_limit;
    return limited > rebound ? limited : rebound;
  }
};

/// Adds `more` to the total impulse of a contact, but limits the sum so that it does not pull; returns the change. So
/// an iteration may take back an excess of an earlier one.
template <class Real>
HOST_DEVICE Real add_unless_pulling(Real& sum, Real more) {
  const Real before = sum, asked = before + more;
  sum = asked > 0 ? asked : Real(0);
  return sum - before;
}

/// Kernel: adds the impulse of contact c to the notes of a tally.
template <class Real>
struct NoteSum {
  Span<const Real> exchanged;
  Span<Real> notes;
  HOST_DEVICE void operator()(int c) const { notes[c] += exchanged[c]; }
};

/// Kernel: the same for the impulse of body i on the floor.
template <class V>
struct NoteFloorSum {
  ImpulseView<V> view;
  WallSums<V> walls;
  Span<const int> body;  ///< the index of body i in the notes; empty: i
  Span<Scalar<V>> notes;

  HOST_DEVICE void operator()(int i) const {
    view.for_each_wall(i, [&](int axis, int side, Scalar<V>) {
      if (axis == 1 && side < 0) notes[body.empty() ? i : body[i]] += walls.at(i, axis, side);
    });
  }
};

/// Kernel: the number of contacts that share the mass of body i. Walls at right angles are independent, so they have
/// one share together. Returns whether there are any.
template <class V>
struct CountShares {
  ImpulseView<V> view;
  Span<Scalar<V>> share;

  HOST_DEVICE bool operator()(int i) const {
    int walls = 0;
    view.for_each_wall(i, [&](int, int, Scalar<V>) { walls = 1; });
    const int shares = view.contacts.count_of(i) + walls;
    share[i] = static_cast<Scalar<V>>(shares);
    return shares != 0;
  }
};

/// Kernel: the constraint of contact c.
template <class V>
struct ConstrainContact {
  ImpulseView<V> view;
  Span<ContactConstraint<V>> constraints;

  HOST_DEVICE void operator()(int c) const {
    const Pair pair = view.contacts.pairs[c];
    const ContactGeometry<V>& contact = view.contacts.geometry[c];
    const auto& [position, velocity, radius, inverse_mass] = view.bodies;
    const Scalar<V> softness = view.share[pair.i] * inverse_mass[pair.i] + view.share[pair.j] * inverse_mass[pair.j];
    const Scalar<V> radii = radius[pair.i] + radius[pair.j];
    const Scalar<V> later = view.later(c, pair, contact.normal);
    constraints[c] = {contact.normal,
                      view.wanted(view.law.restitution, contact.separation, contact.overlap, radii, later),
                      view.removable(contact.separation, contact.overlap, radii), 1 / softness};
  }
};

/// How far body i moves out of the overlap that its new velocity does not remove [m].
template <class V>
struct PositionCorrection {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const ContactConstraint<V>> constraints;
  Span<const V> velocity;

  HOST_DEVICE V operator[](int i) const {
    V move{};
    if (view.share[i] != 0) {
      const V own = velocity[i];
      const Real radius = view.bodies.radius[i];
      view.contacts.for_each_of(i, [&](int c, int other, int side) {
        const ContactConstraint<V>& contact = constraints[c];
        const Real parting = dot(velocity[other] - own, contact.normal) * Real(side);
        const Real left = contact.overlap - view.law.foresight * parting * view.dt;
        move -= contact.normal * (Real(side) * contact.mass * (left > 0 ? left : Real(0)));
        if (side > 0) prefetch_second(view.contacts.pairs, c, velocity.data());
      });
      move *= view.bodies.inverse_mass[i];
      view.for_each_wall(i, [&](int axis, int side, Real overlap) {
        const Real before = -Real(side) * view.bodies.velocity[i][axis], parting = -Real(side) * own[axis];
        const Real left = view.removable(before, overlap, radius) - view.law.foresight * parting * view.dt;
        if (left > 0) move[axis] -= Real(side) * left / view.share[i];
      });
    }
    return move;
  }
};

/// Kernel: stores it.
template <class V>
struct CorrectPosition {
  PositionCorrection<V> correction;
  Span<V> out;  ///< [m]
  HOST_DEVICE void operator()(int i) const { out[i] = correction[i]; }
};

/// Kernel: moves body i by its velocity, and in addition.
template <class V>
struct DriftCorrected {
  PositionCorrection<V> correction;
  Scalar<V> dt;
  Span<V> position;

  HOST_DEVICE void operator()(int i) const {
    const V more = correction[i];  // of the position before
    position[i] = position[i] + correction.velocity[i] * dt + more;
  }
};

}  // namespace ballpit
