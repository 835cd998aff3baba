// SPDX-License-Identifier: MIT
// Keeps a world's tally, if one is wanted: responses record the impulse of each contact, and it is summed up here.
//
//     begin()  notes cleared ──▶ response adds impulses ──▶ end()  Σ Δp·d, impulse on the floor, contacts that are new
//
// A collision is a contact of two spheres that did not touch in the substep before. Costs nothing if no tally is kept.
#pragma once

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

template <class V, class Exec>
class TallyKeeper {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  explicit TallyKeeper(bool is_kept) : is_kept_(is_kept) {}

  /// Where the response records its impulses.
  ImpulseNotes<V> begin(Exec& exec, int64_t bodies, int64_t contacts);

  /// Adds them to the tally. `counts`: new contacts are collisions.
  void end(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, Span<const Pair> pairs,
           Span<const ContactGeometry<V>> geometry, bool counts = true);

  /// The positions of the substep before, by slot.
  Buffer<V>& kept() { return before_; }

  /// What a snapshot holds of the tally.
  struct Saved {
    Tally tally;
    std::vector<V> before;
  };
  Saved save(Exec& exec) const { return {tally_, exec.download(before_.span())}; }
  void restore(Exec& exec, const Saved& saved) {
    tally_ = saved.tally;
    exec.upload(before_, saved.before);
  }

  const Tally& tally() const { return tally_; }
  void go_on_from(const Tally& tally) { tally_ = tally; }
  int64_t bytes() const { return contact_.bytes() + floor_.bytes() + before_.bytes(); }

 private:
  bool is_kept_;
  Tally tally_;
  Buffer<Real> contact_, floor_;
  Buffer<V> before_;
};

template <class V, class Exec>
ImpulseNotes<V> TallyKeeper<V, Exec>::begin(Exec& exec, int64_t bodies, int64_t contacts) {
  if (!is_kept_) return {};
  contact_.resize(contacts);
  floor_.resize(bodies);
  exec.fill("clear notes", contact_.span(), Real(0));
  exec.fill("clear notes", floor_.span(), Real(0));
  return {contact_.span(), floor_.span()};
}

template <class V, class Exec>
void TallyKeeper<V, Exec>::end(Exec& exec, const BodiesView<V>& bodies, const Box<V>& box, Span<const Pair> pairs,
                               Span<const ContactGeometry<V>> geometry, bool counts) {
  if (!is_kept_) return;
  const int64_t n = bodies.size();
  if (before_.size() != n) {
    before_.resize(n);
    exec.parallel_for("note positions", n, CopyValues<V>{bodies.position, before_.span()});
  }
  const Collisions sum =
      reduce(exec, "sum impulses", pairs.size(), Collisions{},
             CollisionOf<V>{bodies, pairs, geometry, box, before_.span(), contact_.span(), counts}, Sum{});
  tally_.collisions += sum.count;
  tally_.virial += sum.virial;
  tally_.floor_impulse += reduce(exec, "sum impulses", n, 0.0, DoubleAt<Real>{floor_.span()}, Sum{});
  if (counts) exec.parallel_for("note positions", n, CopyValues<V>{bodies.position, before_.span()});
}

}  // namespace ballpit
