// SPDX-License-Identifier: MIT
// Impulses: contacts exchange momentum so that spheres part with the speed that restitution requires; remaining overlap
// is pushed apart. There is no friction: impulses act along normals only, so no sphere rotates.
//
//     for each contact (i, j), normal n from i to j, inverse masses w:
//         u  = (v_j − v_i) · n                     present speed of parting
//         u* = e · max(0, −u₀)                     wanted speed, from the speed u₀ before this step's kick
//         λ' = max(0, λ + (u* − u) / (c_i·w_i + c_j·w_j))      total impulse: a contact never pulls
//     v_i ← v_i + w_i · Σ ∓ (λ' − λ) · n
//
// Only the total impulse must not pull, so an iteration may take back an excess of an earlier one. Otherwise spheres
// that part at e = 1 would gain energy from each other's errors.
//
// By default all contacts are solved at once from the same velocities (Jacobi), which is parallel and has a fixed
// order. A body with several contacts would then answer each of them in full and gain energy. So its mass is split
// among its c contacts: each contact solves its own pair of parts, and the parts are averaged. Averaging never adds
// kinetic energy, so an iteration with e = 0 does not either, and momentum is exchanged in equal and opposite portions.
// The first iteration solves a single contact exactly; heaps converge over iterations and steps. Walls at right angles
// are independent: a body solves all of them in one part, so a corner is exact, too. With u₀ from before the kick, a
// ball that bounces with e = 1 rises to the height that it fell from: the kick in the step of the impact is not
// reflected. A ball at rest stays at rest.
//
// The overlap that a contact entered during the last step is removed by moving the bodies, unless their new velocities
// remove it anyway: this adds no energy. Older overlap carries a heap. Under gravity it gets a speed of parting,
// u* = push · overlap / dt, at most push_limit, so that n layers rest at an overlap of at most about c/push·n·g·dt².
// Without gravity it is removed by moving the bodies as well.
//
// With --solver gauss-seidel contacts are solved colour by colour, with c = 1. A stack then needs a quarter of the
// iterations, but each costs one launch per colour, so Jacobi is the default.
//
// Walls follow the same law with w_wall = 0. Cost per iteration: O(n + contacts), one launch (Jacobi).
// Source: mass splitting: Tonge, Benevolenski, Voroshilov, "Mass splitting for jitter-free parallel rigid body
// simulation" (2012), doi 10.1145/2185520.2185601; impulse of a pair: Δp = (1+e)·μ·(v₁₂·n)·n with the reduced mass μ.
#pragma once

#include <utility>

#include "bodies/bodies_view.h"
#include "bodies/contacts.h"
#include "core/span.h"
#include "response/contact_colours.h"
#include "response/impulse_gauss_seidel.h"
#include "response/impulse_jacobi.h"
#include "response/impulse_notes.h"
#include "response/walls_view.h"

namespace ballpit {

template <class V, class Exec>
class ImpulseResponse {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  explicit ImpulseResponse(const ImpulseParameters& parameters) : parameters_(parameters) {}

  /// Resolves all contacts of a step of dt. `bodies` has the velocities before the kick, `kicked` those after it.
  /// Writes the new ones to `velocity`, which may be the same array as `kicked`.
  void respond(Exec& exec, const BodiesView<V>& bodies, const WallsView<V>& walls, const ContactsView<V>& contacts,
               Real dt, Span<const V> kicked, Buffer<V>& velocity, const ImpulseNotes<V>& notes) {
    const int64_t n = bodies.size(), m = contacts.pairs.size();
    share_.resize(n);
    other_.resize(n);
    constraints_.resize(m);
    const ImpulseView<V> view = view_of(bodies, walls, contacts, dt);
    exec.parallel_for("count shares", n, CountShares<V>{view, share_.span()});
    exec.parallel_for("constrain contacts", m, ConstrainContact<V>{view, constraints_.span()});
    exchanged_.resize(m);
    for (Buffer<V>* sums : {&low_, &high_}) sums->resize(walls.box.is_periodic() ? 0 : n);
    const WallSums<V> wall_sums{low_.span(), high_.span()};
    if (parameters_.is_by_colour) {
      solve_by_colour(exec, view, kicked, velocity, wall_sums);
    } else {
      solve_at_once(exec, view, kicked, velocity, wall_sums);
    }
    if (notes.are_kept()) {
      exec.parallel_for("note impulses", m, NoteSum<Real>{exchanged_.span(), notes.contact});
      exec.parallel_for("note impulses", low_.size(), NoteFloorSum<V>{view, wall_sums, notes.floor});
    }
    exec.parallel_for("correct positions", n,
                      CorrectPosition<V>{view, constraints_.span(), velocity.span(), other_.span()});
  }

  /// After respond(): how far each body moves in addition to its velocity [m].
  Span<const V> correction() const { return other_.span(); }

  int64_t bytes() const {
    return share_.bytes() + constraints_.bytes() + other_.bytes() + low_.bytes() + high_.bytes() + exchanged_.bytes() +
           next_exchanged_.bytes() + colours_.bytes();
  }

 private:
  ImpulseView<V> view_of(const BodiesView<V>& bodies, const WallsView<V>& walls, const ContactsView<V>& contacts,
                         Real dt) {
    const auto& p = parameters_;
    return {bodies,
            walls,
            contacts,
            share_.span(),
            dt,
            Real(p.restitution),
            Real(p.wall_restitution),
            Real(p.push),
            Real(p.push_limit),
            Real(p.entered),
            Real(p.correction),
            Real(p.foresight),
            Real(p.slop)};
  }

  void solve_at_once(Exec& exec, const ImpulseView<V>& view, Span<const V> kicked, Buffer<V>& velocity,
                     const WallSums<V>& walls) {
    next_exchanged_.resize(exchanged_.size());
    Span<const V> current = kicked;
    for (int k = 0; k < parameters_.iterations; ++k) {
      exec.parallel_for("resolve velocities", view.bodies.size(),
                        ResolveVelocity<V>{view, constraints_.span(), current, exchanged_.span(), other_.span(),
                                           next_exchanged_.span(), walls, k == 0});
      std::swap(velocity, other_);
      std::swap(exchanged_, next_exchanged_);
      current = velocity.span();
      other_.resize(view.bodies.size());
    }
  }

  void solve_by_colour(Exec& exec, const ImpulseView<V>& view, Span<const V> kicked, Buffer<V>& velocity,
                       const WallSums<V>& walls) {
    const int64_t n = view.bodies.size();
    if (kicked.data() != velocity.span().data()) {
      exec.parallel_for("copy velocities", n, CopyValues<V>{kicked, velocity.span()});
    }
    colours_.build(exec, view.contacts, n);
    exec.fill("clear impulses", walls.low, V{});
    exec.fill("clear impulses", walls.high, V{});
    exec.fill("clear impulses", exchanged_.span(), Real(0));
    for (int k = 0; k < parameters_.iterations; ++k) {
      exec.parallel_for("solve walls", walls.low.size(), SolveWalls<V>{view, velocity.span(), walls});
      colours_.for_each([&](Span<const int> colour) {
        exec.parallel_for("solve contacts", colour.size(),
                          SolveContact<V>{view, constraints_.span(), colour, velocity.span(), exchanged_.span()});
      });
    }
  }

  ImpulseParameters parameters_;
  Buffer<Real> share_;
  Buffer<ContactConstraint<V>> constraints_;
  Buffer<V> other_;       // velocities of the previous iteration, then the corrections
  Buffer<V> low_, high_;  // impulses from walls [kg·m/s]
  Buffer<Real> exchanged_, next_exchanged_;
  ContactColours<V, Exec> colours_;
};

}  // namespace ballpit
