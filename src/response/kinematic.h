// SPDX-License-Identifier: MIT
// Kinematic: a sphere that has run into something moves back out of it, and its velocity is mirrored at the normal. The
// first response of the course's exercise sheet 2: it looks plausible, but is not physics (docs/responses.md).
//
//      last valid  ○╌╌╌╌▸◉ now, in contact       N = the part of v that runs into its contacts
//                  ◂╌╌╌╌╌                         x ← x − N·dt      v ← v − (1 + e)·N
//
// N is the point of the cone {Σ λ·n, λ ≥ 0} that is nearest to v, where n are the normals from the sphere to the
// obstacles that it touches (Moreau). Momentum is not conserved; energy is for e = 1. A sphere that would part by less
// than half a kick has come to rest: it stays in contact, and the contact takes the kick. Walls follow the same law.
// Cost: O(n + contacts), one launch. Source: Moreau, "Unilateral contact and dry friction in finite freedom dynamics"
// (1988), doi 10.1007/978-3-7091-2624-0_1. Its siblings: impulse.h, penalty.h, position_based.h.
#pragma once

#include <cmath>
#include <limits>

#include "bodies/bodies_view.h"
#include "bodies/contacts.h"
#include "bodies/tally.h"
#include "response/walls_view.h"

namespace ballpit {

/// A sphere or a wall that a sphere touches.
template <class V>
struct Obstacle {
  V normal;  ///< from the sphere to the obstacle
  Scalar<V> restitution = 0, overlap = 0;
  bool is_floor = false;
};

/// The obstacles that a vector presses on, and by how much: at most as many as there are dimensions.
template <class V>
struct Pressed {
  using Real = Scalar<V>;
  Obstacle<V> obstacle[kDimensions<V> + 1];
  Real amount[kDimensions<V> + 1];
  int count = 0;

  /// Sets the amounts so that the rest of v is at right angles to all normals; returns the rest.
  HOST_DEVICE V take_from(const V& v) {
    solve(v);
    V left = v;
    for (int k = 0; k < count; ++k) left -= obstacle[k].normal * amount[k];
    return left;
  }

  HOST_DEVICE void remove(int which) {
    --count;
    for (int k = which; k < count; ++k) obstacle[k] = obstacle[k + 1];
  }

  HOST_DEVICE int most_pulling() const {
    int worst = -1;
    for (int k = 0; k < count; ++k) {
      if (amount[k] < 0 && (worst < 0 || amount[k] < amount[worst])) worst = k;
    }
    return worst;
  }

 private:
  /// Least squares: solves the normal equations by elimination. A normal that depends on the others gets amount 0.
  HOST_DEVICE void solve(const V& v) {
    constexpr int kMax = kDimensions<V> + 1;
    Real matrix[kMax][kMax + 1];
    for (int r = 0; r < count; ++r) {
      for (int c = 0; c < count; ++c) matrix[r][c] = dot(obstacle[r].normal, obstacle[c].normal);
      matrix[r][count] = dot(obstacle[r].normal, v);
    }
    for (int k = 0; k < count; ++k) {
      for (int r = k + 1; r < count; ++r) {
        const Real factor = matrix[k][k] > kDependent ? matrix[r][k] / matrix[k][k] : Real(0);
        for (int c = k; c <= count; ++c) matrix[r][c] -= factor * matrix[k][c];
      }
    }
    for (int k = count - 1; k >= 0; --k) {
      Real sum = matrix[k][count];
      for (int c = k + 1; c < count; ++c) sum -= matrix[k][c] * amount[c];
      amount[k] = matrix[k][k] > kDependent ? sum / matrix[k][k] : Real(0);
    }
  }

  static constexpr Real kDependent = Real(1e-4);
};

/// Kernel: mirrors the velocity of body i and computes how far it moves back.
template <class V>
struct MirrorVelocity {
  using Real = Scalar<V>;
  BodiesView<V> bodies;  ///< with the velocities before the kick
  WallsView<V> walls;
  ContactsView<V> contacts;
  Real restitution, wall_restitution, dt;
  KickedVelocity<V> kicked;
  Span<V> velocity;
  Span<V> back;  ///< [m]
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int i) const {
    back[i] = V{};
    bool is_free = true;
    for_each_obstacle(i, [&](const Obstacle<V>&) { is_free = false; });
    if (is_free) {
      velocity[i] = kicked[i];
      return;
    }
    V before = bodies.velocity[i], kick = kicked[i] - before;
    if (walls.is_swept()) {  // the velocity at the first contact, and the rest of the kick
      before += kick * walls.sweep.first[i];
      kick *= 1 - walls.sweep.first[i];
    }
    Pressed<V> hit = pressed_by(i, before, [](const V&) { return true; });
    const V along = hit.take_from(before), into = before - along, after = along - rebound(hit, into);
    V moving = after + kick;
    Pressed<V> held = pressed_by(i, moving + kick / Real(2), [&](const V& normal) {
      return dot(after, normal) <= kSlow * std::sqrt(dot(kick, kick));
    });
    moving = held.take_from(moving);
    velocity[i] = moving;
    back[i] = step_back(hit, into, held.count > 0, bodies.radius[i]);
    if (notes.are_kept()) note_floor(i, hit, held);
  }

 private:
  static constexpr Real kSlow = Real(1e-3);  // fraction of the kick: a sphere that approaches no faster is at rest
  static constexpr Real kSlop = Real(1e-3);  // fraction of the radius: overlap that a resting sphere keeps
  static constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();  // devices cannot call the function
  static constexpr int kMaxRounds = 12;

  template <class Visit>
  HOST_DEVICE void for_each_obstacle(int i, Visit&& visit) const {
    contacts.for_each_of(i, [&](int c, int, int side) {
      const ContactGeometry<V>& contact = contacts.geometry[c];
      visit(Obstacle<V>{contact.normal * Real(side), restitution, contact.overlap, false});
    });
    walls.for_each(i, bodies.position[i], bodies.radius[i], [&](int axis, int side, Real overlap) {
      V normal{};
      normal[axis] = Real(side);
      visit(Obstacle<V>{normal, wall_restitution, overlap, axis == 1 && side < 0});
    });
  }

  /// The part of v in the cone of the normals for which counts(normal) is true: least squares with amounts ≥ 0. Adds
  /// the normal that is pressed most, and removes those that pull (Lawson and Hanson, "Solving Least Squares Problems",
  /// 1974, chapter 23).
  template <class Counts>
  HOST_DEVICE Pressed<V> pressed_by(int i, const V& v, const Counts& counts) const {
    const Real least = 64 * kEpsilon * std::sqrt(dot(v, v));
    Pressed<V> pressed;
    V left = v;
    for (int round = 0; round < kMaxRounds; ++round) {
      Obstacle<V> most;
      Real pressure = least;
      for_each_obstacle(i, [&](const Obstacle<V>& obstacle) {
        const Real into = dot(left, obstacle.normal);
        if (!(into > pressure) || !counts(obstacle.normal)) return;
        pressure = into;
        most = obstacle;
      });
      if (!(pressure > least) || pressed.count > kDimensions<V>) break;
      pressed.obstacle[pressed.count++] = most;
      left = pressed.take_from(v);
      for (int pulling = pressed.most_pulling(); pulling >= 0; pulling = pressed.most_pulling()) {
        pressed.remove(pulling);
        left = pressed.take_from(v);
      }
    }
    return pressed;
  }

  /// Σ e·λ·n, limited to the length of `into`, which it mirrors: with different e at spheres and walls it could be
  /// longer.
  HOST_DEVICE static V rebound(const Pressed<V>& hit, const V& into) {
    V sum{};
    for (int k = 0; k < hit.count; ++k) {
      sum += hit.obstacle[k].normal * (hit.obstacle[k].restitution * hit.amount[k]);
    }
    return no_longer(sum, into);
  }

  /// Moves back by the distance that the last step has entered; a sphere at rest stays in contact.
  HOST_DEVICE V step_back(const Pressed<V>& hit, const V& into, bool rests, Real radius) const {
    V move{};
    for (int k = 0; k < hit.count; ++k) {
      const Real overlap = hit.obstacle[k].overlap, most = overlap - kSlop * radius;
      if (!(overlap > 0)) continue;  // the contact lies ahead
      Real distance = hit.amount[k] * dt;
      if (rests && distance > most) distance = most > 0 ? most : Real(0);
      move -= hit.obstacle[k].normal * distance;
    }
    return no_longer(move, into * dt);
  }

  /// `vector`, shortened to the length of `limit` if it is longer, as it may be between obstacles that face each other.
  HOST_DEVICE static V no_longer(const V& vector, const V& limit) {
    const Real has = dot(vector, vector), most = dot(limit, limit);
    return has > most ? vector * std::sqrt(most / has) : vector;
  }

  HOST_DEVICE void note_floor(int i, const Pressed<V>& hit, const Pressed<V>& held) const {
    Real given = 0;
    for (int k = 0; k < hit.count; ++k) {
      if (hit.obstacle[k].is_floor) given += (1 + hit.obstacle[k].restitution) * hit.amount[k];
    }
    for (int k = 0; k < held.count; ++k) {
      if (held.obstacle[k].is_floor) given += held.amount[k];
    }
    notes.floor[i] += given / bodies.inverse_mass[i];
  }
};

/// Kernel: notes the impulse of contact c. Nothing is exchanged, so it takes the mean of the two bodies' changes of
/// momentum.
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

  /// `bodies` has the velocities before the kick, `kicked` those after it. Writes the new ones to `velocity`.
  void respond(Exec& exec, const BodiesView<V>& bodies, const WallsView<V>& walls, const ContactsView<V>& contacts,
               Real dt, const KickedVelocity<V>& kicked, Buffer<V>& velocity, const ImpulseNotes<V>& notes) {
    const int64_t n = bodies.size();
    back_.resize(n);
    if (notes.are_kept()) {
      exec.parallel_for("note impulses", contacts.count(), NoteMirrored<V>{bodies, contacts, restitution_, notes});
    }
    exec.parallel_for("mirror velocities", n,
                      MirrorVelocity<V>{bodies, walls, contacts, restitution_, wall_restitution_, dt, kicked,
                                        velocity.span(), back_.span(), notes});
  }

  /// After respond(): how far each body moves in addition to its velocity [m].
  Span<const V> correction(Exec&) const { return back_.span(); }

  int64_t bytes() const { return back_.bytes(); }

 private:
  Real restitution_, wall_restitution_;
  Buffer<V> back_;
};

}  // namespace ballpit
