// SPDX-License-Identifier: MIT
// Contact lists by body, with the geometry of each contact. A response can gather for each body instead of scattering
// from each contact: no two threads write to the same body, and sums have a fixed order.
//
//     contact           0      1      2
//     pairs           (0,3)  (0,7)  (2,7)
//     body                  0  1  2  3  4  5  6  7
//     contacts as i       0,1     2                   contiguous, since pairs are sorted by i
//     contacts as j                  0           1,2  "incoming", by a stable counting sort
//
// Cost: O(contacts + n).
#pragma once

#include <cmath>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/contacts.h"

namespace ballpit {

/// Kernel: normal, overlap and separation of contact c. If two centres coincide, the normal is the last axis.
template <class V>
struct MeasureContact {
  BodiesView<V> bodies;
  Box<V> box;
  Span<const Pair> pairs;
  Span<ContactGeometry<V>> geometry;

  HOST_DEVICE void operator()(int c) const {
    const Pair pair = pairs[c];
    const V d = box.displacement(bodies.position[pair.i], bodies.position[pair.j]);
    const Scalar<V> distance = std::sqrt(dot(d, d));
    V normal{};
    normal[kDimensions<V> - 1] = 1;
    if (distance > 0) normal = d / distance;
    geometry[c] = {normal, bodies.radius[pair.i] + bodies.radius[pair.j] - distance,
                   dot(bodies.velocity[pair.j] - bodies.velocity[pair.i], normal)};
  }
};

/// Key: the second body of contact c.
struct SecondBody {
  Span<const Pair> pairs;
  HOST_DEVICE int operator()(int c) const { return pairs[c].j; }
};

/// Value: contact c for the contact list of its second body.
struct IncomingAt {
  Span<const Pair> pairs;
  HOST_DEVICE IncomingContact operator()(int c) const { return {c, pairs[c].i}; }
};

template <class V, class Exec>
class ContactList {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  void build(Exec& exec, Span<const Pair> pairs, Span<const int> first, const BodiesView<V>& bodies,
             const Box<V>& box) {
    link(exec, pairs, first);
    geometry_.resize(pairs.size());
    exec.parallel_for("measure contacts", pairs.size(), MeasureContact<V>{bodies, box, pairs, geometry_.span()});
  }

  /// The lists alone, without the geometry.
  void link(Exec& exec, Span<const Pair> pairs, Span<const int> first) {
    pairs_ = pairs;
    first_ = first;
    geometry_.resize(0);
    incoming_.resize(pairs.size());
    incoming_first_.resize(first.size());
    exec.bin("sort incoming", SecondBody{pairs}, IncomingAt{pairs}, incoming_first_.span(), incoming_.span());
  }

  Span<ContactGeometry<V>> geometry() { return geometry_.span(); }
  ContactsView<V> view() const { return {pairs_, geometry_.span(), first_, incoming_first_.span(), incoming_.span()}; }

 private:
  Span<const Pair> pairs_;
  Span<const int> first_;
  Buffer<ContactGeometry<V>> geometry_;
  Buffer<int> incoming_first_;
  Buffer<IncomingContact> incoming_;
};

}  // namespace ballpit
