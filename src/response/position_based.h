// SPDX-License-Identifier: MIT
// Position-based (XPBD): predicts positions, moves bodies apart until nothing overlaps, and derives the velocities from
// the new positions. Unconditionally stable; the stiffness of a heap depends on substeps and iterations
// (docs/responses.md).
//
//     v ← v + h·g     x ← x + h·v                       predict, and find the contacts there
//     for each contact: C = r_i + r_j − |x_j − x_i|      overlap left; α̃ = compliance / h²
//         Δλ = (C − α̃·λ) / (w_i + w_j + α̃),  λ + Δλ ≥ 0      x ← x ∓ w·Δλ·n
//     v ← v + Σ Δx / h                                   (x − x₀)/h would divide a small difference of large numbers
//     for each contact that pushed: speed of parting ← e·(earlier speed of approach)      restitution
//
// Contacts are solved one after another (Gauss–Seidel, contact_colours.h), walls first and then colour by colour, each
// with the positions that the ones before have left. Restitution applies only above a speed of 2·g·h, so that heaps do
// not jitter. If a run starts with more overlap than its motion explains, Δx changes the velocity only until the
// contact parts at `push` (0 without gravity); the rest of the overlap is removed without changing velocities.
//
// Walls follow the same law with w_wall = 0. Cost per iteration: O(n + contacts), a phase for each colour. Sources:
// Macklin, Müller, Chentanez, "XPBD" (2016), doi 10.1145/2994258.2994272; Macklin et al., "Small Steps in Physics
// Simulation" (2019), doi 10.1145/3309486.3340247; restitution: Müller et al. (2020), doi 10.1111/cgf.14105. Its
// siblings: kinematic.h, impulse.h, penalty.h.
#pragma once

#include <cmath>

#include "bodies/bodies_view.h"
#include "bodies/tally.h"
#include "response/contact_colours.h"
#include "response/walls_view.h"

namespace ballpit {

struct PositionBasedParameters {
  double restitution = 0.8;
  double wall_restitution = 0.8;
  double compliance = 0;  ///< [m/N]
  double gravity = 0;     ///< [m/s²] its length
  int iterations = 1;
};

/// The data that all kernels of the position-based response read.
template <class V>
struct PositionBasedView {
  using Real = Scalar<V>;
  PerBody<Real> radius, inverse_mass;
  Box<V> box;
  ContactsView<V> contacts;
  Real h;           ///< [s] length of the substep
  Real compliance;  ///< α̃ = compliance / h² [1/kg]
  Real restitution, wall_restitution, threshold;
  Span<const V> velocity;  ///< [m/s] kicked
  Real push;               ///< [m/s] largest speed of parting that contacts cause; negative: no limit
  WallSums<V> wall_given;  ///< [kg·m] part of the multipliers that has changed velocities; empty without a limit
  Span<Real> given;

  HOST_DEVICE bool is_limited() const { return push >= 0; }

  /// Calls visit(axis, side) for each wall of the domain.
  template <class Visit>
  HOST_DEVICE void for_each_wall(Visit&& visit) const {
    if (box.is_periodic()) return;
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      visit(axis, -1);
      if (axis != 1 || box.boundary != Boundary::open_top) visit(axis, 1);
    }
  }

  /// The part of a multiplier, now `sum`, that changes velocities now [kg·m], for bodies that part at `parting`.
  HOST_DEVICE Real give(Real sum, Real& given_so_far, Real parting, Real w) const {
    const Real before = given_so_far, asked = before + (push - parting) * h / w;
    given_so_far = asked < 0 ? Real(0) : (asked < sum ? asked : sum);
    return given_so_far - before;
  }

  /// The change of a multiplier [kg·m] for an overlap [m] among inverse masses w; the sum never pulls.
  HOST_DEVICE Real change(Real multiplier, Real overlap, Real w) const {
    const Real asked = multiplier + (overlap - compliance * multiplier) / (w + compliance);
    return (asked > 0 ? asked : Real(0)) - multiplier;
  }

  /// The speed of parting after a contact that parted at `before` (negative: approached).
  HOST_DEVICE Real rebound(Real e, Real before) const { return before < -threshold ? -e * before : Real(0); }
};

/// Phase of a solution by colours: moves body i out of the walls. `walls` sums the multipliers [kg·m], `shift` the body's
/// displacement [m]. In the first iteration sums count as 0: their memory is not initialized. The same holds for contacts.
template <class V>
struct MoveOutOfWalls {
  using Real = Scalar<V>;
  PositionBasedView<V> view;
  Span<V> position, shift;
  WallSums<V> walls;

  HOST_DEVICE void operator()(int i, bool is_first) const {
    const Real w = view.inverse_mass[i], radius = view.radius[i];
    V at = position[i], moved = is_first ? V{} : shift[i];
    view.for_each_wall([&](int axis, int side) {
      Real& sum = walls.at(i, axis, side);
      if (is_first) {
        sum = 0;
        if (view.is_limited()) view.wall_given.at(i, axis, side) = 0;
      }
      const Real p = at[axis];
      const Real overlap = radius - (side < 0 ? p - view.box.min[axis] : view.box.max[axis] - p);
      const Real change = view.change(sum, overlap, w);
      if (change == 0) return;
      sum += change;
      at[axis] -= Real(side) * w * change;
      Real entering = change;
      if (view.is_limited()) {
        const Real parting = -Real(side) * (view.velocity[i][axis] + moved[axis] / view.h);
        entering = view.give(sum, view.wall_given.at(i, axis, side), parting, w);
      }
      moved[axis] -= Real(side) * w * entering;
    });
    position[i] = at;
    shift[i] = moved;
  }
};

/// Phase of a solution by colours: moves the bodies of contact c apart.
template <class V>
struct MoveApart {
  using Real = Scalar<V>;
  PositionBasedView<V> view;
  Span<V> position, shift;
  Span<Real> multiplier;

  HOST_DEVICE void operator()(int c, bool is_first) const {
    if (is_first) {
      multiplier[c] = 0;
      if (view.is_limited()) view.given[c] = 0;
    }
    const Pair pair = view.contacts.pairs[c];
    const V d = view.box.displacement(position[pair.i], position[pair.j]);
    const Real distance = std::sqrt(dot(d, d));
    const V normal = distance > 0 ? d / distance : view.contacts.geometry[c].normal;
    const Real wi = view.inverse_mass[pair.i], wj = view.inverse_mass[pair.j];
    const Real change = view.change(multiplier[c], view.radius[pair.i] + view.radius[pair.j] - distance, wi + wj);
    if (change == 0) return;
    multiplier[c] += change;
    V move = normal * change;
    position[pair.i] -= move * wi;
    position[pair.j] += move * wj;
    if (view.is_limited()) {
      const V relative = view.velocity[pair.j] - view.velocity[pair.i] + (shift[pair.j] - shift[pair.i]) / view.h;
      move = normal * view.give(multiplier[c], view.given[c], dot(relative, normal), wi + wj);
    }
    shift[pair.i] -= move * wi;
    shift[pair.j] += move * wj;
  }
};

/// Phase of a solution by colours: v ← v + shift / h, and restitution of body i at walls that pushed it; `before` has the
/// velocities before the kick.
template <class V>
struct ReboundFromWalls {
  using Real = Scalar<V>;
  PositionBasedView<V> view;
  Span<const V> shift, before;
  WallSums<V> walls;
  Span<V> velocity;
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int i, bool) const {
    V own = velocity[i] + shift[i] / view.h;
    view.for_each_wall([&](int axis, int side) {
      const Real multiplier = walls.at(i, axis, side);
      if (!(multiplier > 0)) return;
      const Real rebound = view.rebound(view.wall_restitution, -Real(side) * before[i][axis]);
      const Real change = rebound + Real(side) * own[axis];
      own[axis] = -Real(side) * rebound;
      if (notes.are_kept() && axis == 1 && side < 0) {
        notes.floor[i] += multiplier / view.h + change / view.inverse_mass[i];
      }
    });
    velocity[i] = own;
  }
};

/// Phase of a solution by colours: restitution of contact c, if it pushed.
template <class V>
struct ReboundApart {
  using Real = Scalar<V>;
  PositionBasedView<V> view;
  Span<const Real> multiplier;
  Span<V> velocity;
  ImpulseNotes<V> notes;

  HOST_DEVICE void operator()(int c, bool) const {
    if (!(multiplier[c] > 0)) return;
    const Pair pair = view.contacts.pairs[c];
    const ContactGeometry<V>& contact = view.contacts.geometry[c];
    const Real wi = view.inverse_mass[pair.i], wj = view.inverse_mass[pair.j];
    const Real parting = dot(velocity[pair.j] - velocity[pair.i], contact.normal);
    const Real impulse = (view.rebound(view.restitution, contact.separation) - parting) / (wi + wj);
    velocity[pair.i] -= contact.normal * (impulse * wi);
    velocity[pair.j] += contact.normal * (impulse * wj);
    if (notes.are_kept()) notes.contact[c] += multiplier[c] / view.h + impulse;
  }
};

template <class V, class Exec>
class PositionBasedResponse {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  explicit PositionBasedResponse(const PositionBasedParameters& parameters) : parameters_(parameters) {}

  /// Moves the bodies of `state` apart and changes their velocities accordingly. They are at their predicted positions,
  /// with kicked velocities; `before` has those before the kick. `push_steps` limits the speed of parting that contacts
  /// cause to the speed of a fall during this number of substeps; negative: no limit.
  template <class State>
  void respond(State& state, const ContactsView<V>& contacts, Span<const V> before, Real h, Real push_steps,
               const ImpulseNotes<V>& notes) {
    Exec& exec = state.exec();
    const BodiesView<V> bodies = state.view();
    const bool is_limited = push_steps >= 0;
    const int64_t n = bodies.size(), at_walls = state.box().is_periodic() ? 0 : n;
    shift_.resize(n);
    multipliers_.resize(at_walls, contacts.pairs.size());
    if (is_limited) given_.resize(at_walls, contacts.pairs.size());
    const auto& p = parameters_;
    const PositionBasedView<V> view{.radius = bodies.radius,
                                    .inverse_mass = bodies.inverse_mass,
                                    .box = state.box(),
                                    .contacts = contacts,
                                    .h = h,
                                    .compliance = Real(p.compliance) / (h * h),
                                    .restitution = Real(p.restitution),
                                    .wall_restitution = Real(p.wall_restitution),
                                    .threshold = Real(2 * p.gravity) * h,
                                    .velocity = state.velocity.span(),
                                    .push = is_limited ? push_steps * Real(p.gravity) * h : push_steps,
                                    .wall_given = given_.walls(),
                                    .given = given_.contact.span()};
    colours_.build(exec, contacts, n);
    colours_.solve(exec, "move apart", n, p.iterations,
                   MoveOutOfWalls<V>{view, state.position.span(), shift_.span(), multipliers_.walls()},
                   MoveApart<V>{view, state.position.span(), shift_.span(), multipliers_.contact.span()});
    Multipliers& pushed = is_limited ? given_ : multipliers_;
    colours_.solve(exec, "rebound", n, 1,
                   ReboundFromWalls<V>{view, shift_.span(), before, pushed.walls(), state.velocity.span(), notes},
                   ReboundApart<V>{view, pushed.contact.span(), state.velocity.span(), notes});
  }

  int64_t bytes() const { return shift_.bytes() + multipliers_.bytes() + given_.bytes() + colours_.bytes(); }

 private:
  struct Multipliers {
    Buffer<V> low, high;
    Buffer<Real> contact;

    void resize(int64_t bodies_at_walls, int64_t contacts) {
      for (Buffer<V>* walls : {&low, &high}) walls->resize(bodies_at_walls);
      contact.resize(contacts);
    }
    WallSums<V> walls() { return {low.span(), high.span()}; }
    int64_t bytes() const { return low.bytes() + high.bytes() + contact.bytes(); }
  };

  PositionBasedParameters parameters_;
  Buffer<V> shift_;
  Multipliers multipliers_, given_;  // the latter only with a limit
  ContactColours<V, Exec> colours_;
};

}  // namespace ballpit
