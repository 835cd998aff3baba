// SPDX-License-Identifier: MIT
// Keeps a world's tally, if one is wanted: responses record the impulse of each contact, and it is summed up here.
//
//     begin()  walls that are new,      ──▶ response adds   ──▶ end()  Σ Δp·d, impulse on the floor,
//              notes cleared                impulses                   contacts that are new
//
// A collision is a contact of two spheres that did not touch in the substep before. A hit of a wall is a contact with
// it that begins likewise, at the positions at which contacts are found: the position-based response then moves spheres
// out of the walls. Where contacts are swept, the drift notes the hits. Costs nothing if no tally is kept.
#pragma once

#include <array>

#include "bodies/contacts.h"
#include "bodies/tally.h"
#include "world/sums.h"

namespace ballpit {

struct Collisions {
  int64_t count = 0;
  double virial = 0;

  HOST_DEVICE Collisions operator+(const Collisions& other) const {
    return {count + other.count, virial + other.virial};
  }
};

/// Map: what contact c adds to the tally.
template <class V>
struct CollisionOf {
  BodiesView<V> bodies;
  Span<const Pair> pairs;
  Span<const ContactGeometry<V>> geometry;  ///< empty: distances are those of the present positions
  Box<V> box;
  Span<const V> before;  ///< positions at the substep before
  Span<const Scalar<V>> impulse;
  bool counts;

  HOST_DEVICE Collisions operator()(int c) const {
    const Pair pair = pairs[c];
    if (!(impulse[c] != 0)) return {};
    const Scalar<V> radii = bodies.radius[pair.i] + bodies.radius[pair.j];
    const bool is_new = counts && !in_contact(box.displacement(before[pair.i], before[pair.j]), radii);
    const V d = box.displacement(bodies.position[pair.i], bodies.position[pair.j]);
    const Scalar<V> distance = geometry.empty() ? std::sqrt(dot(d, d)) : radii - geometry[c].overlap;
    return {is_new ? 1 : 0, double(impulse[c]) * double(distance)};
  }
};

/// Map: the walls that body i touches and did not touch before.
template <class V>
struct WallHitsOf {
  BodiesView<V> bodies;
  Box<V> box;
  Span<const V> before;  ///< positions at the substep before

  HOST_DEVICE int64_t operator()(int i) const {
    int64_t hits = 0;
    const Scalar<V> radius = bodies.radius[i];
    box.for_each_wall(bodies.position[i], radius, [&](int axis, int side, Scalar<V>) {
      const Scalar<V> p = before[i][axis];
      hits += (side < 0 ? p - box.min[axis] : box.max[axis] - p) > radius;
    });
    return hits;
  }
};

template <class V, class Exec>
class TallyKeeper {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// `is_swept`: contacts are found along the way of a step.
  TallyKeeper(bool is_kept, bool is_swept) : is_kept_(is_kept), is_swept_(is_swept) {}

  bool is_kept() const { return is_kept_; }

  /// Where the response records its impulses on `contacts`. Call when these have been found. `counts`: new contacts are
  /// collisions, with walls too.
  ImpulseNotes<V> begin(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, int64_t contacts,
                        bool counts = true);

  /// Adds them to the tally.
  void end(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, Span<const Pair> pairs,
           Span<const ContactGeometry<V>> geometry, bool counts = true);

  /// The positions of the substep before, by slot.
  std::array<Buffer<V>*, 2> kept() { return {&before_, &found_}; }

  /// What a snapshot holds of the tally.
  struct Saved {
    Tally tally;
    std::vector<V> before, found;
  };
  Saved save(Exec& exec) const { return {tally_, exec.download(before_.span()), exec.download(found_.span())}; }
  void restore(Exec& exec, const Saved& saved) {
    tally_ = saved.tally;
    exec.upload(before_, saved.before);
    exec.upload(found_, saved.found);
  }

  const Tally& tally() const { return tally_; }
  void go_on_from(const Tally& tally) { tally_ = tally; }
  int64_t bytes() const {
    return contact_.bytes() + floor_.bytes() + wall_hits_.bytes() + before_.bytes() + found_.bytes();
  }

 private:
  void count_walls(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box);
  void note(Exec& exec, const BodiesView<V>& bodies, Buffer<V>& positions);

  bool is_kept_, is_swept_;
  Tally tally_;
  Buffer<Real> contact_, floor_;
  Buffer<int64_t> wall_hits_;
  Buffer<V> before_, found_;  // positions after the last response, and where its contacts were found
};

template <class V, class Exec>
void TallyKeeper<V, Exec>::note(Exec& exec, const BodiesView<V>& bodies, Buffer<V>& positions) {
  positions.resize(bodies.size());
  exec.parallel_for("note positions", bodies.size(), CopyValues<V>{bodies.position, positions.span()});
}

template <class V, class Exec>
void TallyKeeper<V, Exec>::count_walls(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box) {
  if (found_.size() == bodies.size()) {
    tally_.wall_hits += reduce(exec, "count hits of walls", bodies.size(), int64_t(0),
                               WallHitsOf<V>{bodies, box, found_.span()}, Sum{});
  }
  note(exec, bodies, found_);
}

template <class V, class Exec>
ImpulseNotes<V> TallyKeeper<V, Exec>::begin(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box,
                                            int64_t contacts, bool counts) {
  if (!is_kept_) return {};
  if (counts && !is_swept_ && !box.is_periodic()) count_walls(exec, bodies, box);
  contact_.resize(contacts);
  floor_.resize(bodies.size());
  wall_hits_.resize(is_swept_ ? bodies.size() : 0);
  exec.fill("clear notes", contact_.span(), Real(0));
  exec.fill("clear notes", floor_.span(), Real(0));
  exec.fill("clear notes", wall_hits_.span(), int64_t(0));
  return {contact_.span(), floor_.span(), wall_hits_.span()};
}

template <class V, class Exec>
void TallyKeeper<V, Exec>::end(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, Span<const Pair> pairs,
                               Span<const ContactGeometry<V>> geometry, bool counts) {
  if (!is_kept_) return;
  const int64_t n = bodies.size();
  if (before_.size() != n) note(exec, bodies, before_);
  const Collisions sum =
      reduce(exec, "sum impulses", pairs.size(), Collisions{},
             CollisionOf<V>{bodies, pairs, geometry, box, before_.span(), contact_.span(), counts}, Sum{});
  tally_.collisions += sum.count;
  tally_.virial += sum.virial;
  tally_.floor_impulse += reduce(exec, "sum impulses", n, 0.0, DoubleAt<Real>{floor_.span()}, Sum{});
  tally_.wall_hits +=
      reduce(exec, "count hits of walls", wall_hits_.size(), int64_t(0), ReadValue<int64_t>{wall_hits_.span()}, Sum{});
  if (counts) note(exec, bodies, before_);
}

}  // namespace ballpit
