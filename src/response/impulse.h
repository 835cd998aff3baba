// SPDX-License-Identifier: MIT
// Impulses: contacts exchange momentum so that spheres part with the speed that restitution requires; remaining overlap
// is pushed apart. There is no friction. docs/responses.md explains and measures every rule.
//
//     for each contact (i, j), normal n from i to j, inverse masses w:
//         u  = (v_j − v_i) · n                     present speed of parting
//         u* = e · max(0, −u₀)                     wanted speed, from the speed u₀ before this step's kick
//         λ' = max(0, λ + (u* − u) / (c_i·w_i + c_j·w_j))      total impulse: a contact never pulls
//     v_i ← v_i + w_i · Σ ∓ (λ' − λ) · n
//
// Only the total impulse must not pull, so an iteration may take back an excess of an earlier one. By default all
// contacts are solved at once from the same velocities (Jacobi), and the mass of a body is split among its c contacts:
// an average of the parts never adds energy. Walls are at right angles, so they are one part. With --solver
// gauss-seidel contacts are solved one after another, with c = 1 and the velocities that the ones before have left:
// walls first, then contacts colour by colour (contact_colours.h). That needs fewer iterations, but more phases.
//
// The overlap that a contact entered during the last step is removed by moving the bodies, unless their new velocities
// remove it anyway. Older overlap carries a heap. Under gravity it gets a speed of parting, u* = push · overlap / dt,
// at most push_limit; without gravity it is removed by moving the bodies as well.
//
// Walls follow the same law with w_wall = 0. Cost per iteration: O(n + contacts), one launch (Jacobi). On the CPU, where
// few bodies touch something, only copies of those are solved: touching_bodies.h.
// Source: mass splitting: Tonge, Benevolenski, Voroshilov, "Mass splitting for jitter-free parallel rigid body
// simulation" (2012), doi 10.1145/2185520.2185601; Gauss–Seidel: Catto, "Iterative Dynamics with Temporal Coherence"
// (2005). Its siblings: kinematic.h, penalty.h, position_based.h.
#pragma once

#include <type_traits>
#include <utility>

#include "bodies/tally.h"
#include "response/contact_colours.h"
#include "response/impulse_law.h"
#include "response/touching_bodies.h"

namespace ballpit {

/// Kernel: one Jacobi iteration for body i; reads the velocities and sums of the last iteration, writes new ones.
/// Bodies gather: both bodies of a contact compute its impulse, so no two threads write to the same memory. The first
/// iteration reads velocities that are kicked, and sums count as 0: their memory is not initialized. Nobody reads the
/// velocity of a body without contact, so only the last iteration writes it.
template <class V, bool kIsFirst>
struct ResolveVelocity {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  KickedVelocity<V> kicked;
  bool is_last;
  Span<const ContactConstraint<V>> constraints;
  std::conditional_t<kIsFirst, KickedVelocity<V>, Span<const V>> velocity;
  Span<const Real> exchanged;  ///< total impulse of each contact so far [kg·m/s]
  Span<V> next_velocity;
  Span<Real> next_exchanged;
  WallSums<V> walls;

  HOST_DEVICE void operator()(int i) const {
    if (view.share[i] == 0) {
      if (is_last) next_velocity[i] = kicked[i];
      return;
    }
    const V own = velocity[i];
    const Real inverse_mass = view.bodies.inverse_mass[i];
    V impulse{};
    view.contacts.for_each_of(i, [&](int c, int other, int side) {
      const ContactConstraint<V>& contact = constraints[c];
      const Real parting = dot(velocity[other] - own, contact.normal) * Real(side);
      Real sum = kIsFirst ? Real(0) : exchanged[c];
      impulse -= contact.normal * (Real(side) * add_unless_pulling(sum, contact.mass * (contact.wanted - parting)));
      if (side > 0) {
        next_exchanged[c] = sum;
        prefetch_second(view.contacts.pairs, c, velocity.data());
      }
    });
    if (view.may_touch_wall(i)) {
      V at_walls = own;  // velocity of the one part that meets all walls, one after the other
      const Real part = view.share[i] * inverse_mass;
      view.for_each_wall(i, [&](int axis, int side, Real overlap) {
        Real& sum = walls.at(i, axis, side);
        if (kIsFirst) sum = 0;
        const Real missing = view.missing_at_wall(i, at_walls, axis, side, overlap);
        const Real change = Real(side) * add_unless_pulling(sum, missing / part);
        impulse[axis] -= change;
        at_walls[axis] -= change * part;
      });
    }
    next_velocity[i] = own + impulse * inverse_mass;
  }
};

/// Kernel: the velocity of body i after the kick.
template <class V>
struct StoreKicked {
  KickedVelocity<V> kicked;
  Span<V> out;
  HOST_DEVICE void operator()(int i) const { out[i] = kicked[i]; }
};

/// Phase of a solution by colours: the walls of body i. In the first iteration sums count as 0: their memory is not
/// initialized. The same holds for contacts.
template <class V>
struct SolveWalls {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<V> velocity;
  WallSums<V> walls;

  HOST_DEVICE void operator()(int i, bool is_first) const {
    const Real inverse_mass = view.bodies.inverse_mass[i];
    V own = velocity[i];
    view.for_each_wall(i, [&](int axis, int side, Real overlap) {
      Real& sum = walls.at(i, axis, side);
      if (is_first) sum = 0;
      const Real change = add_unless_pulling(sum, view.missing_at_wall(i, own, axis, side, overlap) / inverse_mass);
      own[axis] -= Real(side) * change * inverse_mass;
    });
    velocity[i] = own;
  }
};

/// Phase of a solution by colours: contact c. `exchanged` is each contact's total impulse [kg·m/s].
template <class V>
struct SolveContact {
  using Real = Scalar<V>;
  ImpulseView<V> view;
  Span<const ContactConstraint<V>> constraints;
  Span<V> velocity;
  Span<Real> exchanged;

  HOST_DEVICE void operator()(int c, bool is_first) const {
    const Pair pair = view.contacts.pairs[c];
    const V normal = constraints[c].normal;
    const Real wi = view.bodies.inverse_mass[pair.i], wj = view.bodies.inverse_mass[pair.j];
    const Real missing = constraints[c].wanted - dot(velocity[pair.j] - velocity[pair.i], normal);
    Real sum = is_first ? Real(0) : exchanged[c];
    const V impulse = normal * add_unless_pulling(sum, missing / (wi + wj));
    exchanged[c] = sum;
    velocity[pair.i] -= impulse * wi;
    velocity[pair.j] += impulse * wj;
  }
};

template <class V, class Exec>
class ImpulseResponse {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  explicit ImpulseResponse(const ImpulseParameters<Real>& parameters) : parameters_(parameters) {}

  /// Resolves all contacts of a step of dt. `bodies` has the velocities before the kick, `kicked` those after it.
  /// Writes the new ones to `velocity`.
  void respond(Exec& exec, const BodiesView<V>& bodies, const WallsView<V>& walls, const ContactsView<V>& contacts,
               Real dt, const KickedVelocity<V>& kicked, Buffer<V>& velocity, const ImpulseNotes<V>& notes) {
    share_.resize(bodies.size());
    const ImpulseView<V> all{bodies, walls, contacts, share_.span(), parameters_, dt};
    const CountShares<V> count{all, share_.span()};
    if constexpr (Exec::kDefers) {
      exec.parallel_for("count shares", bodies.size(), count);
    } else {
      touching_.find(exec, count);
      if (touching_.are_few()) {
        const ImpulseView<V> few = touching_.view(exec, all);
        solve(exec, few, touching_.kicked(exec, all, kicked), solved_, touching_.bodies(), notes);
        touching_.for_each_block(exec, "scatter velocities",
                                 ScatterVelocities<V>{kicked, solved_.span(), velocity.span()});
        return;
      }
    }
    solve(exec, all, kicked, velocity, {}, notes);
  }

  /// After respond(): how far each body moves in addition to its velocity [m].
  Span<const V> correction(Exec& exec) {
    other_.resize(share_.size());
    if constexpr (!Exec::kDefers) {
      if (touching_.are_few()) {
        touching_.for_each_block(exec, "correct positions", ScatterCorrections<V>{correction_, other_.span()});
        return other_.span();
      }
    }
    exec.parallel_for("correct positions", other_.size(), CorrectPosition<V>{correction_, other_.span()});
    return other_.span();
  }

  /// After respond(): moves the bodies by their new velocities, and in addition.
  void drift(Exec& exec, Real dt, Span<const V> velocity, Span<V> position) const {
    if constexpr (!Exec::kDefers) {
      if (touching_.are_few()) {
        touching_.for_each_block(exec, "correct positions and drift",
                                 DriftBlock<V>{correction_, dt, velocity, position});
        return;
      }
    }
    exec.parallel_for("correct positions and drift", position.size(), DriftCorrected<V>{correction_, dt, position});
  }

  int64_t bytes() const {
    return share_.bytes() + constraints_.bytes() + other_.bytes() + low_.bytes() + high_.bytes() + exchanged_.bytes() +
           next_exchanged_.bytes() + colours_.bytes() + solved_.bytes() + touching_.bytes();
  }

 private:
  /// Solves all contacts of a view. `bodies` has the index of each of its bodies among all bodies; empty if the view has
  /// all.
  void solve(Exec& exec, const ImpulseView<V>& view, const KickedVelocity<V>& kicked, Buffer<V>& velocity,
             Span<const int> bodies, const ImpulseNotes<V>& notes) {
    const int64_t n = view.bodies.size(), m = view.contacts.pairs.size();
    velocity.resize(n);
    other_.resize(n);
    constraints_.resize(m);
    exec.parallel_for("constrain contacts", view.contacts.count(), ConstrainContact<V>{view, constraints_.span()});
    exchanged_.resize(m);
    for (Buffer<V>* sums : {&low_, &high_}) sums->resize(view.walls.box.is_periodic() ? 0 : n);
    const WallSums<V> wall_sums{low_.span(), high_.span()};
    if (parameters_.is_by_colour) {
      solve_by_colour(exec, view, kicked, velocity, wall_sums);
    } else {
      solve_at_once(exec, view, kicked, velocity, wall_sums);
    }
    if (notes.are_kept()) {
      exec.parallel_for("note impulses", m, NoteSum<Real>{exchanged_.span(), notes.contact});
      exec.parallel_for("note impulses", low_.size(), NoteFloorSum<V>{view, wall_sums, bodies, notes.floor});
    }
    correction_ = {view, constraints_.span(), velocity.span()};
  }

  void solve_at_once(Exec& exec, const ImpulseView<V>& view, const KickedVelocity<V>& kicked, Buffer<V>& velocity,
                     const WallSums<V>& walls) {
    next_exchanged_.resize(exchanged_.size());
    const auto iterate = [&]<bool kIsFirst>(const auto& current, int k) {
      exec.parallel_for(
          "resolve velocities", view.bodies.size(),
          ResolveVelocity<V, kIsFirst>{view, kicked, k + 1 == parameters_.iterations, constraints_.span(), current,
                                       exchanged_.span(), other_.span(), next_exchanged_.span(), walls});
      std::swap(velocity, other_);
      std::swap(exchanged_, next_exchanged_);
      other_.resize(view.bodies.size());
    };
    iterate.template operator()<true>(kicked, 0);
    for (int k = 1; k < parameters_.iterations; ++k) {
      iterate.template operator()<false>(Span<const V>(velocity.span()), k);
    }
  }

  void solve_by_colour(Exec& exec, const ImpulseView<V>& view, const KickedVelocity<V>& kicked, Buffer<V>& velocity,
                       const WallSums<V>& walls) {
    const int64_t n = view.bodies.size();
    exec.parallel_for("kick", n, StoreKicked<V>{kicked, velocity.span()});
    colours_.build(exec, view.contacts, n);
    colours_.solve(exec, "solve contacts", walls.low.size(), parameters_.iterations,
                   SolveWalls<V>{view, velocity.span(), walls},
                   SolveContact<V>{view, constraints_.span(), velocity.span(), exchanged_.span()});
  }

  ImpulseParameters<Real> parameters_;
  Buffer<Real> share_;
  Buffer<ContactConstraint<V>> constraints_;
  PositionCorrection<V> correction_;
  Buffer<V> other_;       // velocities of the previous iteration; then corrections, where they are asked for
  Buffer<V> low_, high_;  // impulses from walls [kg·m/s]
  Buffer<Real> exchanged_, next_exchanged_;
  ContactColours<V, Exec> colours_;
  TouchingBodies<V, Exec> touching_;
  Buffer<V> solved_;  // velocities of bodies that touch something, where those are few
};

}  // namespace ballpit
