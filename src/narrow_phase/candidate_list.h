// SPDX-License-Identifier: MIT
// A candidate list with a skin (Verlet list): a search among spheres enlarged by a skin finds all pairs that may come
// into contact soon. Until a sphere has moved farther than its skin, only these pairs are tested.
//
//        ╭╌╌╌╌╌╮          sphere i with its skin: radius r·(1 + skin)
//       ╎ ╭───╮ ╎         pairs whose skins overlap are stored row by row, like contacts
//       ╎ │ i │ ╎         valid while |x − x₀| ≤ skin·r for every sphere: spheres whose skins did not overlap then
//       ╎ ╰───╯ ╎         cannot be in contact now
//        ╰╌╌╌╌╌╯
//
// Cost: a broad phase each time the list is made; otherwise O(n + candidates), about six candidates a sphere in a dense
// heap. Memory: 12 or 8 bytes a body and 8 a candidate. Source: Verlet, "Computer Experiments on Classical Fluids"
// (1967), doi 10.1103/PhysRev.159.98.
#pragma once

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "narrow_phase/contact_rows.h"

namespace ballpit {

/// The rows of a list as candidates.
struct ListedCandidates {
  Span<const int> first;
  Span<const Pair> pairs;

  /// Calls visit(j) for each j > i in i's row, until visit returns false.
  template <class Visit>
  HOST_DEVICE void for_each(int i, Visit&& visit) const {
    for (int k = first[i]; k < first[i + 1]; ++k) {
      if (!visit(pairs[k].j)) return;
    }
  }
};

/// Predicate: body i could leave the domain while the list stays valid.
template <class V>
struct IsNearBorder {
  BodiesView<V> bodies;
  Box<V> box;
  Scalar<V> skin;  ///< fraction of the radius

  HOST_DEVICE bool operator()(int i) const {
    if (box.is_periodic()) return !box.holds(bodies.position[i]);  // there is no border to cross
    const V reach(skin * bodies.radius[i]);
    return !(box.holds(bodies.position[i] - reach) & box.holds(bodies.position[i] + reach));
  }
};

/// Kernel: larger radii.
template <class Real>
struct GrowRadius {
  PerBody<Real> radius;
  Real factor, margin;
  Span<Real> grown;
  HOST_DEVICE void operator()(int i) const { grown[i] = radius[i] * factor + margin; }
};

/// The bodies with radius · factor + margin [m], stored in `memory`.
template <class V, class Exec, class Buffer>
BodiesView<V> grow_radii(Exec& exec, BodiesView<V> bodies, Scalar<V> factor, Scalar<V> margin, Buffer& memory) {
  const bool is_uniform = bodies.radius.is_uniform();
  memory.resize(is_uniform ? 1 : bodies.size());
  if (bodies.size() > 0) {
    exec.parallel_for("grow radii", memory.size(), GrowRadius<Scalar<V>>{bodies.radius, factor, margin, memory.span()});
  }
  bodies.radius = {memory.span().data(), is_uniform ? 0 : 1};
  return bodies;
}

/// Predicate: body i has moved farther than its skin. Compiled for either kind of domain, so that it becomes vector
/// instructions in one without period.
template <class V, bool kPeriodic>
struct HasLeftSkin {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const V> start;
  Real skin;   ///< fraction of the radius
  Real guard;  ///< bound on the rounding error [m]

  HOST_DEVICE bool operator()(int i) const {
    const V moved = kPeriodic ? box.displacement(start[i], bodies.position[i]) : bodies.position[i] - start[i];
    const Real allowed = skin * bodies.radius[i] - guard;
    return !((allowed > 0) & (dot(moved, moved) <= allowed * allowed));  // true for NaN
  }
};

/// What a candidate list is for the present positions.
enum class ListState {
  fresh,  ///< it holds every pair that may be in contact
  due,    ///< it is to be made anew
  off,    ///< there is none: no skin, or bodies are too fast for it
};

template <class V, class Exec>
class CandidateList {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// `skin` is a fraction of each radius, 0: no list. `guard` bounds the rounding error of a distance [m].
  void plan(double skin, double guard) {
    skin_ = static_cast<Real>(skin);
    guard_ = static_cast<Real>(guard);
    pause_ = 0;
    discard();
  }

  bool is_used() const { return skin_ > 0; }

  /// Call after exchanging bodies, or sorting them in memory.
  void discard() {
    is_valid_ = false;
    uses_ = kWorthwhile;
  }

  /// Call after changing positions.
  void moved() { is_checked_ = false; }

  /// Whether the list serves these bodies, whose radii include `margin` [m].
  ListState state(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, Real margin) {
    if (!is_used()) return ListState::off;
    if (margin_ < margin) discard();
    if (pause_ > 0) {
      --pause_;
      return ListState::off;
    }
    if (is_valid(exec, bodies, box)) {
      ++uses_;
      return ListState::fresh;
    }
    if (uses_ >= kWorthwhile) return ListState::due;
    pause_ = kPause;
    uses_ = kWorthwhile;
    return ListState::off;
  }

  /// Whether every body is still within its skin, so that the list holds every pair that may be in contact.
  bool is_valid(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box) {
    if (!is_valid_ || start_.size() != bodies.size()) return false;
    if (is_checked_) return true;
    is_valid_ = is_checked_ =
        box.is_periodic() ? !has_left_skin<true>(exec, bodies, box) : !has_left_skin<false>(exec, bodies, box);
    return is_valid_;
  }

  /// Whether a fresh list shows that all bodies are finite and inside the domain.
  bool shows_all_inside(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box) {
    return is_used() && pause_ == 0 && is_clear_ && is_valid(exec, bodies, box);
  }

  /// The bodies with enlarged radii, for the search that makes the list.
  BodiesView<V> grown(Exec& exec, const BodiesView<V>& bodies) {
    return grow_radii(exec, bodies, factor(), Real(0), grown_);
  }
  Real factor() const { return 1 + skin_; }

  /// The output of that search. Call start() after it, to store the positions.
  ContactRows<Exec>& rows() { return rows_; }
  void start(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, Real margin = 0) {
    margin_ = margin;
    uses_ = 1;
    start_.resize(bodies.size());
    exec.parallel_for("note positions", bodies.size(), CopyValues<V>{bodies.position, start_.span()});
    is_clear_ = !any(exec, "check border", bodies.size(), IsNearBorder<V>{bodies, box, skin_});
    is_valid_ = is_checked_ = true;
  }

  ListedCandidates candidates() const { return {rows_.first(), rows_.pairs()}; }
  int64_t bytes() const { return start_.bytes() + grown_.bytes() + rows_.bytes(); }

 private:
  // Making a list costs about two searches; where one served fewer positions than this, the next is made after a pause.
  static constexpr int kWorthwhile = 3;
  static constexpr int kPause = 30;

  /// Whether any body has.
  template <bool kPeriodic>
  bool has_left_skin(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box) const {
    return any(exec, "check skins", bodies.size(),
               HasLeftSkin<V, kPeriodic>{bodies, box, start_.span(), skin_, guard_});
  }

  Real skin_ = 0, guard_ = 0;
  Real margin_ = 0;         // [m] for which the list was made
  int uses_ = kWorthwhile;  // positions that it has served
  int pause_ = 0;           // positions until the next is made
  bool is_valid_ = false;
  bool is_checked_ = false;  // for the present positions
  bool is_clear_ = false;    // no skin extends beyond the domain
  Buffer<V> start_;
  Buffer<Real> grown_;
  ContactRows<Exec> rows_;
};

}  // namespace ballpit
