// SPDX-License-Identifier: MIT
// Contacts measured and listed by body, so that a response can gather for each body instead of scattering from each
// contact: no two threads write to one body, and sums have one order.
//
//     contact           0      1      2
//     pairs           (0,3)  (0,7)  (2,7)
//     body                  0  1  2  3  4  5  6  7
//     contacts as i       0,1     2                   contiguous, since pairs are sorted by i
//     contacts as j                  0           1,2  "incoming", by count, scan and fill; rows sorted
//
// Cost: O(contacts + n).
#pragma once

#include "exec/atomics.h"
#include "simulate/narrowphase/find_contacts.h"
#include "simulate/state.h"

namespace ballpit {

/// Kernel: normal, overlap and speed of contact c. Where two centres coincide, the normal is the last axis.
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

/// Kernel: counts contact c for its second body.
struct CountIncoming {
  Span<const Pair> pairs;
  Span<int> count;

  HOST_DEVICE void operator()(int c) const { atomic_add(&count[pairs[c].j], 1); }
};

/// Kernel: lists contact c with its second body; `count` counts down to zero.
struct FillIncoming {
  Span<const Pair> pairs;
  Span<const int> first;
  Span<int> count;
  Span<IncomingContact> incoming;

  HOST_DEVICE void operator()(int c) const {
    const Pair pair = pairs[c];
    incoming[first[pair.j] + atomic_add(&count[pair.j], -1) - 1] = {c, pair.i};
  }
};

/// Kernel: sorts body i's row, whose order depended on the threads.
struct SortIncoming {
  Span<const int> first;
  Span<IncomingContact> incoming;

  HOST_DEVICE void operator()(int i) const {
    for (int k = first[i] + 1; k < first[i + 1]; ++k) {
      const IncomingContact moved = incoming[k];
      int at = k;
      for (; at > first[i] && incoming[at - 1].contact > moved.contact; --at) incoming[at] = incoming[at - 1];
      incoming[at] = moved;
    }
  }
};

template <class V, class Exec>
class ContactList {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  void build(Exec& exec, const ContactFinder<V, Exec>& found, const BodiesView<V>& bodies, const Box<V>& box) {
    const int64_t n = bodies.size();
    pairs_ = found.pairs();
    first_ = found.first();
    geometry_.resize(pairs_.size());
    exec.parallel_for("measure contacts", pairs_.size(), MeasureContact<V>{bodies, box, pairs_, geometry_.span()});

    count_.resize(n);
    incoming_first_.resize(n + 1);
    incoming_.resize(pairs_.size());
    exec.fill("clear incoming", count_.span(), 0);
    exec.parallel_for("count incoming", pairs_.size(), CountIncoming{pairs_, count_.span()});
    exec.exclusive_scan("scan incoming", count_.span(), incoming_first_.span());
    exec.parallel_for("fill incoming", pairs_.size(),
                      FillIncoming{pairs_, incoming_first_.span(), count_.span(), incoming_.span()});
    exec.parallel_for("sort incoming", n, SortIncoming{incoming_first_.span(), incoming_.span()});
  }

  ContactsView<V> view() const { return {pairs_, geometry_.span(), first_, incoming_first_.span(), incoming_.span()}; }

 private:
  Span<const Pair> pairs_;
  Span<const int> first_;
  Buffer<ContactGeometry<V>> geometry_;
  Buffer<int> count_, incoming_first_;
  Buffer<IncomingContact> incoming_;
};

}  // namespace ballpit
