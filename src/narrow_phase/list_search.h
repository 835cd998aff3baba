// SPDX-License-Identifier: MIT
// Tests the candidates in lists and writes the contacts in canonical order, by count, scan and fill. Sizes are exact,
// no atomic operations append, and the indices alone determine the order, whatever the order of the candidates.
//
//     body              0  1  2  3          kernel "count contacts": tests candidates, counts contacts,
//     contacts found    2  0  1  0          keeps the first kKept of them
//     first             0  2  2  3  3       scan
//     pairs             (0,3) (0,7) (2,5)   kernel "fill contacts": writes each row, sorted by j
//
// Cost: one pass over the candidates; a second one only for bodies with more contacts than were kept.
// Its sibling for candidates in ranges is range_search.h.
#pragma once

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/pair.h"
#include "core/span.h"
#include "narrow_phase/contact_rows.h"

namespace ballpit {

/// Kernel: counts the tests and the contacts of body i.
template <class V, class Candidates>
struct CountContacts {
  Candidates candidates;
  BodiesView<V> bodies;
  Box<V> box;
  Span<int> tested;
  Span<int> found;
  Span<int> kept;  ///< kKept for each body

  HOST_DEVICE void operator()(int i) const {
    const V position = bodies.position[i];
    const Scalar<V> radius = bodies.radius[i];
    int tests = 0, contacts = 0;
    candidates.for_each(i, [&](int j) {
      ++tests;
      if (in_contact(box.displacement(position, bodies.position[j]), radius + bodies.radius[j])) {
        if (contacts < kKept) kept[int64_t(i) * kKept + contacts] = j;
        ++contacts;
      }
      return true;
    });
    tested[i] = tests;
    found[i] = contacts;
  }
};

/// Kernel: writes body i's contacts into its row, sorted by j.
template <class V, class Candidates>
struct FillContacts {
  Candidates candidates;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const int> first;
  Span<const int> kept;
  Span<Pair> pairs;

  HOST_DEVICE void operator()(int i) const {
    const int begin = first[i], end = first[i + 1];
    if (end - begin <= kKept) {
      for (int k = 0; begin + k < end; ++k) pairs[begin + k] = {i, kept[int64_t(i) * kKept + k]};
    } else {
      fill_again(i, begin, end);
    }
    sort_row(pairs.data() + begin, end - begin);
  }

 private:
  HOST_DEVICE void fill_again(int i, int begin, int end) const {
    const V position = bodies.position[i];
    const Scalar<V> radius = bodies.radius[i];
    int filled = begin;
    candidates.for_each(i, [&](int j) {
      if (in_contact(box.displacement(position, bodies.position[j]), radius + bodies.radius[j])) {
        pairs[filled++] = {i, j};
      }
      return filled < end;
    });
  }
};

template <class V, class Exec>
class ListSearch {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  template <class Candidates>
  void find(Exec& exec, const Candidates& candidates, const BodiesView<V>& bodies, const Box<V>& box,
            ContactRows<Exec>& rows) {
    const int64_t n = bodies.size();
    tested_.resize(n);
    found_.resize(n);
    kept_.resize(n * kKept);
    rows.resize(n, 0);
    exec.parallel_for(
        "count contacts", n,
        CountContacts<V, Candidates>{candidates, bodies, box, tested_.span(), found_.span(), kept_.span()});
    const int64_t total = exec.exclusive_scan("scan contacts", found_.span(), rows.first());
    rows.resize_pairs(checked_count(total, "contacts"));
    exec.parallel_for("fill contacts", n,
                      FillContacts<V, Candidates>{candidates, bodies, box, rows.first(), kept_.span(), rows.pairs()});
  }

  Span<const int> tested() const { return tested_.span(); }  ///< the number of candidates that each body tested
  int64_t candidates(Exec& exec) const { return sum_of(exec, tested()); }
  int64_t bytes() const { return tested_.bytes() + found_.bytes() + kept_.bytes(); }

 private:
  Buffer<int> tested_, found_, kept_;
};

}  // namespace ballpit
