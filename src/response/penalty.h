// SPDX-License-Identifier: MIT
// Penalty: a spring and a dashpot along the normal oppose overlap, and a dashpot across it opposes sliding (shear), as
// in the course's exercise sheet 2. Contacts last, waves travel, and the step must be well below a contact's duration.
//
//        i ●──/\/\/\──● j      F = k·δ − c·u            linear: c = 2ζ·√(k·m*)
//          ●───▐█═────●        F = K·δ^1.5 − c·δ^¼·u    Hertz:  c = √5·ζ·√(K·m*)
//                              δ overlap [m], u speed of parting [m/s], m* reduced mass [kg]
//
// Restitution determines ζ (pair_force.h). Walls follow the same law with m* = m. The pairs of a candidate list are
// used directly; those that do not touch have force 0. Where the CPU has at most two threads, one goes along the pairs
// and adds each force to both bodies (ordered_forces.h); otherwise bodies gather their forces, in the same order. Cost:
// O(n + contacts) for each evaluation of the forces. Source: Cundall and Strack, "A discrete numerical model for granular
// assemblies" (1979), doi 10.1680/geot.1979.29.1.47. Its siblings: kinematic.h, impulse.h, position_based.h.
#pragma once

#include "bodies/contacts.h"
#include "bodies/tally.h"
#include "exec/reduce.h"
#include "response/ordered_forces.h"

namespace ballpit {

/// Kernel: the force of pair c on its second body [N], 0 if they do not touch.
template <class V>
struct StorePairForce {
  using Real = Scalar<V>;
  PairForce<V> force_of;
  Span<const Pair> pairs;
  Span<V> force;
  Real duration;  ///< [s] during which the force acts, for a tally
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int c) const {
    Real along;
    force[c] = force_of(pairs[c], along);
    if (notes.are_kept()) notes.contact[c] += along * duration;
  }
};

/// Kernel: the sum of the pair forces on body i [N].
template <class V>
struct GatherForces {
  ContactsView<V> pairs;
  Span<const V> force;
  Span<V> sum;

  HOST_DEVICE void operator()(int i) const {
    V result{};
    pairs.for_each_of(i, [&](int c, int, int side) { result -= force[c] * Scalar<V>(side); });
    sum[i] = result;
  }
};

/// Kernel: the acceleration of body i by contacts, walls and gravity [m/s²].
template <class V, class Sum>
struct Accelerate {
  using Real = Scalar<V>;
  PenaltyLaw<Real> law;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const Sum> sum;  ///< of each body's pair forces [N]
  V gravity;
  Span<V> acceleration;
  Real duration;
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int i) const {
    V force{};
    for (int axis = 0; axis < kDimensions<V>; ++axis) force[axis] = sum[i][axis];
    const Real inverse_mass = bodies.inverse_mass[i];
    box.for_each_wall(bodies.position[i], bodies.radius[i],
                      [&](int axis, int side, Real overlap) { add_wall(i, axis, side, overlap, force); });
    acceleration[i] = gravity + force * inverse_mass;
  }

  HOST_DEVICE void add_wall(int i, int axis, int side, Real overlap, V& force) const {
    const V v = bodies.velocity[i];
    const Real dashpot = law.dashpot(law.wall_damping, 1 / bodies.inverse_mass[i]);
    const Real along = law.force(dashpot, overlap, -Real(side) * v[axis]);
    force[axis] -= Real(side) * along;
    for (int other = 0; law.shear > 0 && other < kDimensions<V>; ++other) {
      if (other != axis) force[other] -= law.shear * v[other];
    }
    if (notes.are_kept() && axis == 1 && side < 0) notes.floor[i] += along * duration;
  }
};

/// Map: the energy in the spring of contact c [J].
template <class V>
struct ContactEnergy {
  PenaltyLaw<Scalar<V>> law;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const Pair> pairs;

  HOST_DEVICE double operator()(int c) const {
    const Pair pair = pairs[c];
    const V d = box.displacement(bodies.position[pair.i], bodies.position[pair.j]);
    const Scalar<V> overlap = bodies.radius[pair.i] + bodies.radius[pair.j] - std::sqrt(dot(d, d));
    return overlap > 0 ? law.energy(overlap) : 0;
  }
};

/// Map: the energy in the springs between body i and walls [J].
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
  /// `notes_impulses`: impulses will be recorded.
  PenaltyResponse(const PenaltyLaw<Real>& law, bool notes_impulses) : law_(law), notes_impulses_(notes_impulses) {}

  /// Whether the forces depend on velocities.
  bool depends_on_velocity() const { return law_.damping > 0 || law_.wall_damping > 0 || law_.shear > 0; }

  /// Whether one thread adds up the forces along the pairs: two threads that gather them by body take longer
  /// (ordered_forces.h). Otherwise pairs are to be listed by body.
  bool adds_in_order(const Exec& exec) const {
    if constexpr (kHasOrderedForces<V, Exec>) {
      return exec.threads() <= 2 && ordered_.is_available() && !notes_impulses_ && law_.shear == 0;
    }
    return false;
  }

  /// The accelerations of all bodies [m/s²] at their present positions and velocities, which act for `duration` [s];
  /// `pairs` include all contacts. Sums run in the order of the pairs, whichever thread makes them.
  template <class Bodies>
  void accelerate(Bodies& state, const ContactsView<V>& pairs, Real duration, const ImpulseNotes<V>& notes,
                  Span<V> acceleration) {
    Exec& exec = state.exec();
    if constexpr (kHasOrderedForces<V, Exec>) {
      if (adds_in_order(exec)) {
        const Span<const int> at_walls = ordered_.accelerate(state, pairs.pairs, law_, acceleration);
        if (at_walls.empty()) return;
        const auto accelerate = acceleration_of(state, ordered_.sum(), duration, notes, acceleration);
        exec.parallel_for("accelerate at walls", at_walls.size(), [=](int k) { accelerate(at_walls[k]); });
        return;
      }
    }
    force_.resize(pairs.pairs.size());
    sum_.resize(state.count());
    const PairForce<V> force_of{law_, state.view(), state.box()};
    exec.parallel_for("pair forces", pairs.count(),
                      StorePairForce<V>{force_of, pairs.pairs, force_.span(), duration, notes});
    exec.parallel_for("gather forces", state.count(), GatherForces<V>{pairs, force_.span(), sum_.span()});
    const Span<const V> sum = sum_.span();
    exec.parallel_for("accelerate", state.count(), acceleration_of(state, sum, duration, notes, acceleration));
  }

  /// [J] in all springs. `pairs` are the contacts.
  double elastic_energy(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, Span<const Pair> pairs) const {
    return reduce(exec, "sum springs", pairs.size(), 0.0, ContactEnergy<V>{law_, bodies, box, pairs}, Sum{}) +
           reduce(exec, "sum springs", bodies.size(), 0.0, WallEnergy<V>{law_, bodies, box}, Sum{});
  }

  int64_t bytes() const { return force_.bytes() + sum_.bytes() + ordered_.bytes(); }

 private:
  template <class State, class Sum>
  Accelerate<V, Sum> acceleration_of(State& state, Span<const Sum> sum, Real duration, const ImpulseNotes<V>& notes,
                                     Span<V> acceleration) const {
    return {law_, state.view(), state.box(), sum, state.gravity(), acceleration, duration, notes};
  }

  PenaltyLaw<Real> law_;
  bool notes_impulses_;
  Buffer<V> force_, sum_;
  OrderedForces<V, Exec> ordered_;
};

}  // namespace ballpit
