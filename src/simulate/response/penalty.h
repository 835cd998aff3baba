// SPDX-License-Identifier: MIT
// Penalty: overlap is answered by a spring and a dashpot along the normal, and by a dashpot across it (shear), as in the
// course's exercise sheet 2. Contacts last, waves travel, and the step must be well below a contact's duration.
//
//        i ●──/\/\/\──● j      F = k·δ − c·u            linear: c = 2ζ·√(k·m*)
//          ●───▐█═────●        F = K·δ^1.5 − c·δ^¼·u    Hertz:  c = √5·ζ·√(K·m*)
//                              δ overlap [m], u speed of parting [m/s], m* reduced mass [kg]
//
// For both laws ζ follows from restitution alone: in y = δ^(5/4) and dτ = δ^¼ dt Hertz's contact is a linear oscillator
// (Antypov and Elliott 2011, doi 10.1209/0295-5075/94/50004). A contact ends where the overlap does, or, if asked for, where
// the force would begin to pull (Schwager and Pöschel 2007, doi 10.1007/s10035-007-0065-z). Spheres carry no rotation.
// Walls follow the same law with m* = m. Cost: O(n + contacts) for each evaluation of the forces.
// Source: Cundall and Strack, "A discrete numerical model for granular assemblies" (1979), doi 10.1680/geot.1979.29.1.47.
// Its siblings: kinematic.h, impulse.h, position_based.h.
#pragma once

#include <cmath>

#include "exec/reduce.h"
#include "simulate/response/damping.h"
#include "simulate/state.h"

namespace ballpit {

/// The force of a contact.
template <class Real>
struct PenaltyLaw {
  Real stiffness;     ///< k [N/m], or K [N/m^1.5]
  Real damping;       ///< ζ between spheres
  Real wall_damping;  ///< ζ at walls
  Real shear;         ///< [kg/s]
  bool is_hertz;
  bool ends_with_force;

  /// [N] pushing apart. `mass` is the reduced mass.
  HOST_DEVICE Real force(Real zeta, Real overlap, Real separation, Real mass) const {
    Real spring = stiffness * overlap, dashpot = 0;
    if (is_hertz) spring *= std::sqrt(overlap);
    if (zeta > 0) {
      dashpot = zeta * std::sqrt(stiffness * mass) * separation;
      dashpot *= is_hertz ? Real(2.2360679774997896964) * std::sqrt(std::sqrt(overlap)) : Real(2);
    }
    const Real force = spring - dashpot;
    return ends_with_force && force < 0 ? Real(0) : force;
  }

  /// [J] held by the spring.
  HOST_DEVICE double energy(Real overlap) const {
    const double d = double(overlap);
    return is_hertz ? 0.4 * double(stiffness) * d * d * std::sqrt(d) : 0.5 * double(stiffness) * d * d;
  }
};

/// Kernel: the force of contact c on its second body; the first body's is opposite [N].
template <class V>
struct ContactForce {
  using Real = Scalar<V>;
  PenaltyLaw<Real> law;
  BodiesView<V> bodies;
  ContactsView<V> contacts;
  Span<V> force;
  Real duration;  ///< [s] that the force acts, for a tally
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int c) const {
    const Pair pair = contacts.pairs[c];
    const ContactGeometry<V>& contact = contacts.geometry[c];
    const Real mass = 1 / (bodies.inverse_mass[pair.i] + bodies.inverse_mass[pair.j]);
    const Real along = law.force(law.damping, contact.overlap, contact.separation, mass);
    V sum = contact.normal * along;
    if (law.shear > 0) {
      const V v = bodies.velocity[pair.j] - bodies.velocity[pair.i];
      sum -= (v - contact.normal * contact.separation) * law.shear;
    }
    force[c] = sum;
    if (notes.are_kept()) notes.contact[c] += along * duration;
  }
};

/// Kernel: the acceleration of body i by its contacts, its walls and gravity [m/s²].
template <class V>
struct GatherForces {
  using Real = Scalar<V>;
  PenaltyLaw<Real> law;
  BodiesView<V> bodies;
  Box<V> box;
  ContactsView<V> contacts;
  Span<const V> force;
  V gravity;
  Span<V> acceleration;
  Real duration;
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int i) const {
    V sum{};
    contacts.for_each_of(i, [&](int c, int, int side) { sum -= force[c] * Real(side); });
    const Real inverse_mass = bodies.inverse_mass[i];
    add_walls(i, 1 / inverse_mass, sum);
    acceleration[i] = gravity + sum * inverse_mass;
  }

  HOST_DEVICE void add_walls(int i, Real mass, V& sum) const {
    const V v = bodies.velocity[i];
    box.for_each_wall(bodies.position[i], bodies.radius[i], [&](int axis, int side, Real overlap) {
      const Real along = law.force(law.wall_damping, overlap, -Real(side) * v[axis], mass);
      sum[axis] -= Real(side) * along;
      for (int other = 0; law.shear > 0 && other < kDimensions<V>; ++other) {
        if (other != axis) sum[other] -= law.shear * v[other];
      }
      if (notes.are_kept() && axis == 1 && side < 0) notes.floor[i] += along * duration;
    });
  }
};

/// Map: energy in the spring of contact c.
template <class V>
struct ContactEnergy {
  PenaltyLaw<Scalar<V>> law;
  Span<const ContactGeometry<V>> geometry;
  HOST_DEVICE double operator()(int c) const { return law.energy(geometry[c].overlap); }
};

/// Map: energy in the springs between body i and walls.
template <class V>
struct WallEnergy {
  PenaltyLaw<Scalar<V>> law;
  BodiesView<V> bodies;
  Box<V> box;
  HOST_DEVICE double operator()(int i) const {
    double sum = 0;
    box.for_each_wall(bodies.position[i], bodies.radius[i],
                      [&](int, int, Scalar<V> overlap) { sum += law.energy(overlap); });
    return sum;
  }
};

template <class V, class Exec>
class PenaltyResponse {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  explicit PenaltyResponse(const PenaltyLaw<Real>& law) : law_(law) {}

  /// Whether velocities matter to the forces.
  bool depends_on_velocity() const { return law_.damping > 0 || law_.wall_damping > 0 || law_.shear > 0; }

  /// The accelerations of all bodies [m/s²] that act for `duration` [s].
  void accelerate(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, const ContactsView<V>& contacts,
                  const V& gravity, Real duration, const ImpulseNotes<V>& notes, Span<V> acceleration) {
    force_.resize(contacts.pairs.size());
    exec.parallel_for("contact forces", force_.size(),
                      ContactForce<V>{law_, bodies, contacts, force_.span(), duration, notes});
    exec.parallel_for(
        "gather forces", bodies.size(),
        GatherForces<V>{law_, bodies, box, contacts, force_.span(), gravity, acceleration, duration, notes});
  }

  /// [J] in all springs.
  double elastic_energy(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box,
                        const ContactsView<V>& contacts) const {
    return reduce(exec, "sum springs", contacts.pairs.size(), 0.0, ContactEnergy<V>{law_, contacts.geometry}, Sum{}) +
           reduce(exec, "sum springs", bodies.size(), 0.0, WallEnergy<V>{law_, bodies, box}, Sum{});
  }

  int64_t bytes() const { return force_.bytes(); }

 private:
  PenaltyLaw<Real> law_;
  Buffer<V> force_;
};

}  // namespace ballpit
