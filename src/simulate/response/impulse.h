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
// Walls follow the same law with w_wall = 0. Cost per iteration: O(n + contacts), one launch.
// Source: mass splitting: Tonge, Benevolenski, Voroshilov, "Mass splitting for jitter-free parallel rigid body
// simulation" (2012), doi 10.1145/2185520.2185601; impulse of a pair: Δp = (1+e)·μ·(v₁₂·n)·n with the reduced mass μ.
#pragma once

#include "simulate/state.h"

namespace ballpit {

struct ImpulseParameters {
  double restitution = 0.8;       ///< sphere–sphere
  double wall_restitution = 0.8;  ///< sphere–wall
  int iterations = 6;
  double slop = 0.005;            ///< overlap left alone, as a fraction of the sum of radii: contacts stay contacts
  double correction = 0.4;        ///< part of the overlap beyond it that a step removes
};

/// What every kernel of the impulse response reads.
template <class V>
struct ImpulseView {
  using Real = Scalar<V>;
  BodiesView<V> bodies;  ///< with the velocities before the kick
  Box<V> box;
  ContactsView<V> contacts;
  Span<const Real> share;  ///< contacts of each body, walls included
  Real restitution, wall_restitution;

  /// c_i·w_i + c_j·w_j of two bodies in contact [1/kg]
  HOST_DEVICE Real softness(int i, int j) const {
    return share[i] * bodies.inverse_mass[i] + share[j] * bodies.inverse_mass[j];
  }
};

/// e · max(0, −u₀): the speed of parting that a contact of relative speed u₀ wants.
template <class Real>
HOST_DEVICE Real rebound(Real restitution, Real separation) {
  return separation < 0 ? -restitution * separation : Real(0);
}

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

/// Kernel: one Jacobi iteration for body i; reads the velocities before it, writes those after.
template <class V>
struct ResolveVelocity {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const V> velocity;
  Span<V> out;

  HOST_DEVICE void operator()(int i) const {
    const V own = velocity[i];
    if (view.share[i] == 0) {
      out[i] = own;
      return;
    }
    V change{};
    const Real inverse_mass = view.bodies.inverse_mass[i];
    view.contacts.for_each_of(i, [&](int c, int other, int side) {
      const ContactGeometry<V>& contact = view.contacts.geometry[c];
      const Real parting = dot(velocity[other] - own, contact.normal) * Real(side);
      const Real missing = rebound(view.restitution, contact.separation) - parting;
      if (missing > 0) {
        const Real impulse = missing / view.softness(i, other);
        change -= contact.normal * (Real(side) * impulse * inverse_mass);
      }
    });
    view.box.for_each_wall(view.bodies.position[i], view.bodies.radius[i], [&](int axis, int side, Real) {
      const Real before = -Real(side) * view.bodies.velocity[i][axis], parting = -Real(side) * own[axis];
      const Real missing = rebound(view.wall_restitution, before) - parting;
      if (missing > 0) change[axis] -= Real(side) * missing / view.share[i];
    });
    out[i] = own + change;
  }
};

/// Kernel: how far body i moves out of what overlap this step's velocities do not resolve by themselves.
template <class V>
struct CorrectPosition {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Real dt, slop, factor;
  Span<const V> velocity;
  Span<V> correction;

  HOST_DEVICE void operator()(int i) const {
    V move{};
    if (view.share[i] != 0) {
      const V own = velocity[i];
      const Real inverse_mass = view.bodies.inverse_mass[i], radius = view.bodies.radius[i];
      view.contacts.for_each_of(i, [&](int c, int other, int side) {
        const ContactGeometry<V>& contact = view.contacts.geometry[c];
        const Real parting = dot(velocity[other] - own, contact.normal) * Real(side);
        const Real left = contact.overlap - parting * dt - slop * (radius + view.bodies.radius[other]);
        if (left > 0) {
          move -= contact.normal * (Real(side) * factor * left * inverse_mass / view.softness(i, other));
        }
      });
      view.box.for_each_wall(view.bodies.position[i], radius, [&](int axis, int side, Real overlap) {
        const Real left = overlap + Real(side) * own[axis] * dt - slop * radius;
        if (left > 0) move[axis] -= Real(side) * factor * left / view.share[i];
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
    const int64_t n = bodies.size();
    share_.resize(n);
    other_.resize(n);
    exec.parallel_for("count shares", n, CountShares<V>{bodies, box, contacts, share_.span()});
    const ImpulseView<V> view{bodies, box, contacts, share_.span(), static_cast<Real>(parameters_.restitution),
                              static_cast<Real>(parameters_.wall_restitution)};
    for (int k = 0; k < parameters_.iterations; ++k) {
      exec.parallel_for("resolve velocities", n, ResolveVelocity<V>{view, velocity.span(), other_.span()});
      std::swap(velocity, other_);
    }
    exec.parallel_for("correct positions", n,
                      CorrectPosition<V>{view, dt, static_cast<Real>(parameters_.slop),
                                         static_cast<Real>(parameters_.correction), velocity.span(), other_.span()});
  }

  /// How far each body is to move beside its velocity [m], after respond().
  Span<const V> correction() const { return other_.span(); }

 private:
  ImpulseParameters parameters_;
  Buffer<Scalar<V>> share_;
  Buffer<V> other_;  // velocities of the other iteration, then the correction
};

}  // namespace ballpit
