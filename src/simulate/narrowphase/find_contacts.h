// SPDX-License-Identifier: MIT
// From candidates to contacts in canonical order, by count, scan and fill: sizes are exact, nothing is appended by
// atomics, and the order is fixed by the indices whatever order the candidates come in.
//
//     body              0  1  2  3          kernel "count contacts": candidates tested, contacts found,
//     contacts found    2  0  1  0          the first kKept of them kept
//     first             0  2  2  3  3       scan
//     pairs             (0,3) (0,7) (2,5)   kernel "fill contacts": each row sorted by j
//
// Cost: one walk over the candidates; a second one only by bodies with more contacts than were kept.
#pragma once

#include <limits>
#include <string>

#include "core/error.h"
#include "simulate/state.h"

namespace ballpit {

/// Contacts that a body keeps from counting to filling. Equal spheres have at most twelve, half of them with a higher
/// index on average.
inline constexpr int kKept = 8;

/// Kernel: counts what body i is tested against, and what it touches.
template <class V, class Candidates>
struct CountContacts {
  Candidates candidates;
  BodiesView<V> bodies;
  Box<V> box;
  Span<int> tested;
  Span<int> found;
  Span<int> kept;  ///< kKept a body

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
      for (int k = 0; begin + k < end; ++k) insert_sorted(begin, begin + k, {i, kept[int64_t(i) * kKept + k]});
      return;
    }
    const V position = bodies.position[i];
    const Scalar<V> radius = bodies.radius[i];
    int filled = begin;
    candidates.for_each(i, [&](int j) {
      if (in_contact(box.displacement(position, bodies.position[j]), radius + bodies.radius[j])) {
        insert_sorted(begin, filled++, {i, j});
      }
      return filled < end;
    });
  }

  /// Insertion sort: rows are short.
  HOST_DEVICE void insert_sorted(int begin, int at, Pair pair) const {
    for (; at > begin && pairs[at - 1].j > pair.j; --at) pairs[at] = pairs[at - 1];
    pairs[at] = pair;
  }
};

/// Throws RunError where a number of entries exceeds what an index holds.
inline int checked_count(int64_t count, const char* what) {
  if (count > std::numeric_limits<int>::max()) {
    throw RunError("too many " + std::string(what) + ": " + std::to_string(count) + "; at most " +
                   std::to_string(std::numeric_limits<int>::max()) + " can be held");
  }
  return static_cast<int>(count);
}

/// Buffers of one search, kept from step to step.
template <class V, class Exec>
class ContactFinder {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  template <class Candidates>
  void find(Exec& exec, const Candidates& candidates, const BodiesView<V>& bodies, const Box<V>& box) {
    const int64_t n = bodies.size();
    tested_.resize(n);
    found_.resize(n);
    first_.resize(n + 1);
    kept_.resize(n * kKept);
    exec.parallel_for(
        "count contacts", n,
        CountContacts<V, Candidates>{candidates, bodies, box, tested_.span(), found_.span(), kept_.span()});
    const int64_t total = exec.exclusive_scan("scan contacts", found_.span(), first_.span());
    pairs_.resize(checked_count(total, "contacts"));
    exec.parallel_for("fill contacts", n,
                      FillContacts<V, Candidates>{candidates, bodies, box, first_.span(), kept_.span(), pairs_.span()});
  }

  Span<const Pair> pairs() const { return pairs_.span(); }
  Span<const int> first() const { return first_.span(); }
  Span<const int> tested() const { return tested_.span(); }  ///< candidates tested by each body

 private:
  Buffer<int> tested_, found_, first_, kept_;
  Buffer<Pair> pairs_;
};

}  // namespace ballpit
