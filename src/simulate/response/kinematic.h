// SPDX-License-Identifier: MIT
// Kinematic: a sphere that touches something goes back to its last valid position, and its velocity is mirrored at the
// normal. The first answer of the course's exercise sheet 2: plausible, and not physics.
//
//      last valid  ○╌╌╌╌▸◉ now, in contact          v ← v − (1 + e)·(v·n)·n   for each contact that v runs into,
//                  ◂╌╌╌╌╌                            n from the sphere to what it touches
//
// Each sphere is mirrored as if what it touches were a wall: nothing is exchanged. So momentum is not conserved; energy is,
// for e = 1; and spheres that are held in contact, as in a heap, hover where they were last free.
// Walls follow the same law. Cost: O(n + contacts), one launch; 12 or 8 bytes a body for the last valid position.
// Its siblings: impulse.h, penalty.h, position_based.h.
#pragma once

#include "simulate/state.h"

namespace ballpit {

/// Kernel: mirrors the velocity of body i and tells how far it is to go back.
template <class V>
struct MirrorVelocity {
  using Real = Scalar<V>;
  BodiesView<V> bodies;  ///< with the velocities before the kick
  WallsView<V> walls;
  ContactsView<V> contacts;
  Real restitution, wall_restitution;
  Span<V> valid;  ///< [m] last valid positions
  Span<const V> kicked;
  Span<V> velocity;
  Span<V> back;  ///< [m]
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int i) const {
    const V p = bodies.position[i], before = bodies.velocity[i];
    V change{};
    bool is_free = true, is_valid = true;  // a contact that lies ahead leaves the position valid
    contacts.for_each_of(i, [&](int c, int, int side) {
      is_free = false;
      is_valid = is_valid && !(contacts.geometry[c].overlap > 0);
      const V normal = contacts.geometry[c].normal * Real(side);
      const Real into = dot(before + change, normal);
      if (into > 0) change -= normal * ((1 + restitution) * into);
    });
    walls.for_each(i, p, bodies.radius[i], [&](int axis, int side, Real overlap) {
      is_free = false;
      is_valid = is_valid && !(overlap > 0);
      const Real into = Real(side) * (before[axis] + change[axis]);
      if (into <= 0) return;
      change[axis] -= Real(side) * (1 + wall_restitution) * into;
      if (notes.are_kept() && axis == 1 && side < 0)
        notes.floor[i] += (1 + wall_restitution) * into / bodies.inverse_mass[i];
    });
    velocity[i] = is_free ? kicked[i] : before + change;
    if (is_valid) valid[i] = p;
    back[i] = walls.box.displacement(p, valid[i]);
  }
};

/// Kernel: what contact c exchanges, as far as that can be said where nothing is: the mean of what its two bodies take.
template <class V>
struct NoteMirrored {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  ContactsView<V> contacts;
  Real restitution;
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int c) const {
    const Pair pair = contacts.pairs[c];
    const V normal = contacts.geometry[c].normal;
    const Real of_i = dot(bodies.velocity[pair.i], normal), of_j = -dot(bodies.velocity[pair.j], normal);
    const Real taken = (of_i > 0 ? of_i / bodies.inverse_mass[pair.i] : Real(0)) +
                       (of_j > 0 ? of_j / bodies.inverse_mass[pair.j] : Real(0));
    notes.contact[c] += (1 + restitution) * taken / 2;
  }
};

template <class V, class Exec>
class KinematicResponse {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  KinematicResponse(double restitution, double wall_restitution)
      : restitution_(Real(restitution)), wall_restitution_(Real(wall_restitution)) {}

  /// `bodies` hold the velocities before the kick, `kicked` those after it; on return `velocity` holds the response's. It
  /// may be the same as `kicked`.
  void respond(Exec& exec, const BodiesView<V>& bodies, const WallsView<V>& walls, const ContactsView<V>& contacts,
               Real, Span<const V> kicked, Buffer<V>& velocity, const ImpulseNotes<V>& notes) {
    const int64_t n = bodies.size();
    if (valid_.size() != n) {
      valid_.resize(n);
      exec.parallel_for("note positions", n, CopyValues<V>{bodies.position, valid_.span()});
    }
    back_.resize(n);
    if (notes.are_kept()) {
      exec.parallel_for("note impulses", contacts.pairs.size(), NoteMirrored<V>{bodies, contacts, restitution_, notes});
    }
    exec.parallel_for("mirror velocities", n,
                      MirrorVelocity<V>{bodies, walls, contacts, restitution_, wall_restitution_, valid_.span(), kicked,
                                        velocity.span(), back_.span(), notes});
  }

  /// How far each body is to move beside its velocity [m], after respond().
  Span<const V> correction() const { return back_.span(); }

  /// What is kept for each body.
  Buffer<V>* kept() { return &valid_; }

  int64_t bytes() const { return valid_.bytes() + back_.bytes(); }

 private:
  Real restitution_, wall_restitution_;
  Buffer<V> valid_, back_;
};

}  // namespace ballpit
