// SPDX-License-Identifier: MIT
// Contact lists by body, with the geometry of each contact. A response can gather for each body instead of scattering
// from each contact: no two threads write to the same body, and sums have a fixed order.
//
//     contact           0      1      2
//     pairs           (0,3)  (0,7)  (2,7)
//     body                  0  1  2  3  4  5  6  7
//     contacts as i       0,1     2                   contiguous, since pairs are sorted by i
//     contacts as j                  0           1,2  "incoming", by a stable counting sort; where rows come with
//                                                     counters (row_search.h), by these, and then sorted for each body
//
// Cost: O(contacts + n).
#pragma once

#include <cmath>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/contacts.h"
#include "narrow_phase/contact_rows.h"

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
    prefetch_second(pairs, c, bodies.position.data());
    prefetch_second(pairs, c, bodies.velocity.data());
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

/// Kernel: lists contact c for its second body, anywhere in its list. The counters are 0 afterwards.
struct ListIncoming {
  Span<const int> lower_first;
  Span<int> lower;
  Span<IncomingContact> incoming;

  HOST_DEVICE void operator()(int c, const Pair& pair) const {
    incoming[lower_first[pair.j] + atomic_add(&lower[pair.j], -1) - 1] = {c, pair.i};
  }
};

/// Kernel: sorts the row of body i, and then measures and lists its contacts.
template <class V>
struct MeasureRow {
  SortRow sort;
  MeasureContact<V> measure;
  ListIncoming list;
  bool is_sorted, is_measured;

  HOST_DEVICE void operator()(int i) const {
    if (!is_sorted) sort(i);
    for (int c = sort.first[i]; c < sort.first[i + 1]; ++c) {
      if (is_measured) measure(c);
      list(c, sort.pairs[c]);
    }
  }
};

/// Kernel: sorts the list of body i.
struct SortIncoming {
  Span<const int> lower_first;
  Span<IncomingContact> incoming;

  HOST_DEVICE void operator()(int i) const {
    const int begin = lower_first[i], count = lower_first[i + 1] - begin;
    if (count > 1) sort_row(incoming.data() + begin, count);
  }
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

  /// The same, and sorts the rows if they are not sorted yet.
  void build(Exec& exec, ContactRows<Exec>& rows, const BodiesView<V>& bodies, const Box<V>& box) {
    if (rows.lower_first().empty()) {
      rows.sort(exec);
      build(exec, rows.pairs(), rows.first(), bodies, box);
    } else {
      geometry_.resize(rows.pairs().size());
      list_rows(exec, rows, {bodies, box, rows.pairs(), geometry_.span()}, true);
    }
  }

  void link(Exec& exec, ContactRows<Exec>& rows) {
    if (rows.lower_first().empty()) {
      rows.sort(exec);
      link(exec, rows.pairs(), rows.first());
    } else {
      geometry_.resize(0);
      list_rows(exec, rows, {}, false);
    }
  }

  /// The lists alone, without the geometry.
  void link(Exec& exec, Span<const Pair> pairs, Span<const int> first) {
    pairs_ = pairs;
    first_ = first;
    geometry_.resize(0);
    incoming_.resize(pairs.size());
    incoming_first_.resize(first.size());
    exec.bin("sort incoming", SecondBody{pairs}, IncomingAt{pairs}, incoming_first_.span(), incoming_.span());
    starts_ = incoming_first_.span();
  }

  Span<ContactGeometry<V>> geometry() { return geometry_.span(); }
  ContactsView<V> view() const { return {pairs_, geometry_.span(), first_, starts_, incoming_.span()}; }

 private:
  /// By the counters of the rows.
  void list_rows(Exec& exec, ContactRows<Exec>& rows, const MeasureContact<V>& measure, bool is_measured) {
    pairs_ = rows.pairs();
    first_ = rows.first();
    starts_ = rows.lower_first();
    incoming_.resize(pairs_.size());
    const int64_t n = first_.size() - 1;
    exec.parallel_for("list contacts", n,
                      MeasureRow<V>{{rows.first(), rows.pairs()},
                                    measure,
                                    {starts_, rows.lower(), incoming_.span()},
                                    rows.is_sorted(),
                                    is_measured});
    exec.parallel_for("sort incoming", n, SortIncoming{starts_, incoming_.span()});
    rows.note_sorted();
    rows.note_listed();
  }

  Span<const Pair> pairs_;
  Span<const int> first_, starts_;
  Buffer<ContactGeometry<V>> geometry_;
  Buffer<int> incoming_first_;
  Buffer<IncomingContact> incoming_;
};

}  // namespace ballpit
