// SPDX-License-Identifier: MIT
// Impulses: contacts exchange momentum so that spheres part with the speed that restitution asks for; what overlap is
// left is pushed apart. Frictionless: impulses act along normals alone, so no sphere needs a rotation.
//
//     for each contact (i, j), normal n from i to j, inverse masses w:
//         u  = (v_j − v_i) · n                     speed of parting, now
//         u* = e · max(0, −u₀)                     wanted, from the speed u₀ before this step's kick
//         λ  = max(0, u* − u) / (c_i·w_i + c_j·w_j)
//     v_i ← v_i + w_i · Σ ∓ λ · n
//
// All contacts are solved at once from the same velocities (Jacobi), which is parallel and has one order. Solved
// naively, a body with several contacts would answer each of them in full and gain energy. So each body's mass is split
// among its c contacts: each solves its own pair of parts, and the parts are averaged. Averaging never adds kinetic
// energy, so neither does an iteration with e = 0, and momentum is exchanged in equal and opposite portions. A single
// contact is solved exactly by the first iteration; heaps converge over iterations and steps.
// Taking u₀ before the kick makes a ball that bounces with e = 1 rise to where it fell from: the kick of the step of
// impact is not reflected. A ball at rest stays at rest.
//
// Overlap that a contact entered during the last step is undone by position, as far as its new velocity does not take
// it out by itself: that adds no energy. Overlap that was there before is what carries a heap: where gravity presses,
// it wants a speed of parting, u* = push · overlap / dt, at most push_limit, so that n layers rest at an overlap of at
// most about c/push·n·g·dt². Without gravity nothing presses, and it is removed by position as well.
//
// Walls follow the same law with w_wall = 0. Cost per iteration: O(n + contacts), one launch.
// Source: mass splitting: Tonge, Benevolenski, Voroshilov, "Mass splitting for jitter-free parallel rigid body
// simulation" (2012), doi 10.1145/2185520.2185601; impulse of a pair: Δp = (1+e)·μ·(v₁₂·n)·n with the reduced mass μ.
#pragma once

#include <utility>

#include "simulate/state.h"

namespace ballpit {

struct ImpulseParameters {
  double restitution = 0.8;       ///< sphere–sphere
  double wall_restitution = 0.8;  ///< sphere–wall
  double push = 0.8;              ///< part of the old overlap that a step pushes out by velocity …
  double push_limit = 0.0;        ///< [m/s] … at this speed at most
  double correction = 0.0;        ///< part of the old overlap that a step removes by position
  double slop = 0.005;  ///< overlap left alone, as a fraction of r_i + r_j, or of r at a wall: contacts stay contacts
  int iterations = 4;
};

/// What a contact needs in every iteration.
template <class V>
struct ContactConstraint {
  V normal;           ///< from i to j
  Scalar<V> wanted;   ///< speed of parting wanted [m/s]
  Scalar<V> overlap;  ///< overlap to be removed by position, as far as parting does not remove it [m]
  Scalar<V> mass;     ///< effective mass 1 / (c_i·w_i + c_j·w_j) [kg]
};

/// What every kernel of the impulse response reads.
template <class V>
struct ImpulseView {
  using Real = Scalar<V>;
  BodiesView<V> bodies;  ///< with the velocities before the kick
  Box<V> box;
  ContactsView<V> contacts;
  Span<const Real> share;  ///< c: contacts of each body, walls included
  Real dt, restitution, wall_restitution, push, push_limit, correction, slop;

  /// How far a contact that parted at `separation` before the step moved into overlap during the last one [m].
  HOST_DEVICE Real entered(Real separation, Real overlap) const {
    const Real moved = separation < 0 ? -separation * dt : Real(0);
    return moved < overlap ? moved : overlap;
  }

  /// The overlap that was there before the last step, less the slop [m].
  HOST_DEVICE Real old_overlap(Real separation, Real overlap, Real radii) const {
    const Real old = overlap - entered(separation, overlap) - slop * radii;
    return old > 0 ? old : Real(0);
  }

  /// The overlap to be removed by position [m].
  HOST_DEVICE Real removable(Real separation, Real overlap, Real radii) const {
    return entered(separation, overlap) + correction * old_overlap(separation, overlap, radii);
  }

  /// The speed of parting that a contact wants: what restitution asks for, or what pushes old overlap out.
  HOST_DEVICE Real wanted(Real e, Real separation, Real overlap, Real radii) const {
    const Real rebound = separation < 0 ? -e * separation : Real(0);
    const Real out = push * old_overlap(separation, overlap, radii) / dt;
    const Real limited = out < push_limit ? out : push_limit;
    return limited > rebound ? limited : rebound;
  }
};

/// Kernel: how many contacts body i splits its mass among.
template <class V>
struct CountShares {
  BodiesView<V> bodies;
  Box<V> box;
  ContactsView<V> contacts;
  Span<Scalar<V>> share;

  HOST_DEVICE void operator()(int i) const {
    int count = contacts.count_of(i);
    box.for_each_wall(bodies.position[i], bodies.radius[i], [&](int, int, Scalar<V>) { ++count; });
    share[i] = static_cast<Scalar<V>>(count);
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
    constraints[c] = {contact.normal, view.wanted(view.restitution, contact.separation, contact.overlap, radii),
                      view.removable(contact.separation, contact.overlap, radii), 1 / softness};
  }
};

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
    const Real radius = view.bodies.radius[i];
    view.box.for_each_wall(view.bodies.position[i], radius, [&](int axis, int side, Real overlap) {
      const Real before = -Real(side) * view.bodies.velocity[i][axis], parting = -Real(side) * own[axis];
      const Real missing = view.wanted(view.wall_restitution, before, overlap, radius) - parting;
      if (missing > 0) change[axis] -= Real(side) * missing / view.share[i];
    });
    out[i] = own + change;
  }
};

/// Kernel: how far body i steps back out of what it entered, as far as the velocities do not take it out themselves.
template <class V>
struct CorrectPosition {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const ContactConstraint<V>> constraints;
  Span<const V> velocity;
  Span<V> correction;

  HOST_DEVICE void operator()(int i) const {
    V move{};
    if (view.share[i] != 0) {
      const V own = velocity[i];
      const Real radius = view.bodies.radius[i];
      view.contacts.for_each_of(i, [&](int c, int other, int side) {
        const ContactConstraint<V>& contact = constraints[c];
        const Real parting = dot(velocity[other] - own, contact.normal) * Real(side);
        const Real left = contact.overlap - parting * view.dt;
        move -= contact.normal * (Real(side) * contact.mass * (left > 0 ? left : Real(0)));
      });
      move *= view.bodies.inverse_mass[i];
      view.box.for_each_wall(view.bodies.position[i], radius, [&](int axis, int side, Real overlap) {
        const Real before = -Real(side) * view.bodies.velocity[i][axis], parting = -Real(side) * own[axis];
        const Real left = view.removable(before, overlap, radius) - parting * view.dt;
        if (left > 0) move[axis] -= Real(side) * left / view.share[i];
      });
    }
    correction[i] = move;
  }
};

template <class V, class Exec>
class ImpulseResponse {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  explicit ImpulseResponse(const ImpulseParameters& parameters) : parameters_(parameters) {}

  /// Resolves all contacts of a step of dt. `bodies` hold the velocities before the kick, `velocity` those after it;
  /// on return `velocity` holds the response's.
  void respond(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, const ContactsView<V>& contacts,
               Scalar<V> dt, Buffer<V>& velocity) {
    using Real = Scalar<V>;
    const int64_t n = bodies.size(), m = contacts.pairs.size();
    share_.resize(n);
    other_.resize(n);
    constraints_.resize(m);
    const auto& p = parameters_;
    const ImpulseView<V> view{bodies,
                              box,
                              contacts,
                              share_.span(),
                              dt,
                              Real(p.restitution),
                              Real(p.wall_restitution),
                              Real(p.push),
                              Real(p.push_limit),
                              Real(p.correction),
                              Real(p.slop)};
    exec.parallel_for("count shares", n, CountShares<V>{bodies, box, contacts, share_.span()});
    exec.parallel_for("constrain contacts", m, ConstrainContact<V>{view, constraints_.span()});
    for (int k = 0; k < p.iterations; ++k) {
      exec.parallel_for("resolve velocities", n,
                        ResolveVelocity<V>{view, constraints_.span(), velocity.span(), other_.span()});
      std::swap(velocity, other_);
    }
    exec.parallel_for("correct positions", n,
                      CorrectPosition<V>{view, constraints_.span(), velocity.span(), other_.span()});
  }

  /// How far each body is to move beside its velocity [m], after respond().
  Span<const V> correction() const { return other_.span(); }

 private:
  ImpulseParameters parameters_;
  Buffer<Scalar<V>> share_;
  Buffer<ContactConstraint<V>> constraints_;
  Buffer<V> other_;  // velocities of the other iteration, then the correction
};

}  // namespace ballpit
