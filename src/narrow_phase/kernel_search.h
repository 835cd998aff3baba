// SPDX-License-Identifier: MIT
// Tests the candidates of a broad phase by kernels on any executor, and writes the contacts in canonical order, by
// count, scan and fill. Sizes are exact, no atomic operations append, and the indices alone determine the order,
// whatever the order of the candidates.
//
//     thread            0  1  2  3          kernel "count contacts": tests candidates, counts contacts,
//     contacts found    2  0  1  0          keeps the first kKept of them
//     first             0  2  2  3  3       scan
//     pairs             (0,3) (0,7) (2,5)   kernel "fill contacts": writes each thread's pairs
//
// Lists have a thread for each body, so its pairs are the body's row, which the kernel sorts by j. Ranges have one for
// each slot; afterwards their pairs are sorted by i (a counting sort), and each row by j.
//
// Cost: one pass over the candidates, two for threads with more contacts than are kept; with ranges O(contacts + n) to
// sort. Its sibling for the CPU in single precision is vector_search.h.
#pragma once

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/slots.h"
#include "narrow_phase/contact_rows.h"

namespace ballpit {

/// How many contacts a thread keeps from counting to filling. Equal spheres have at most twelve, and on average half of
/// them have a higher index.
inline constexpr int kKept = 8;

/// What thread i does with candidates in lists; if not kTests, each counts as a contact.
template <class V, class Candidates, bool kTests>
struct ListTester {
  static constexpr bool kIsRow = true;  ///< the pairs of a thread are a row
  Candidates candidates;
  BodiesView<V> bodies;
  Box<V> box;

  /// Calls visit(j) for each contact, until it returns false. Returns the number of tests.
  template <class Visit>
  HOST_DEVICE int for_each_contact(int i, Visit&& visit) const {
    const V position = bodies.position[i];
    const Scalar<V> radius = bodies.radius[i];
    int tests = 0;
    candidates.for_each(i, [&](int j) {
      ++tests;
      if (kTests && !in_contact(box.displacement(position, bodies.position[j]), radius + bodies.radius[j])) return true;
      return visit(j);
    });
    return tests;
  }

  HOST_DEVICE int body_of(int i) const { return i; }
  HOST_DEVICE Pair pair_of(int i, int j) const { return {i, j}; }
};

/// What thread t does with candidates in ranges.
template <class V, class Candidates, bool kTests>
struct RangeTester {
  static constexpr bool kIsRow = false;
  Candidates candidates;
  Box<V> box;

  /// Calls visit(s) for each slot in contact. Returns the number of tests.
  template <class Visit>
  HOST_DEVICE int for_each_contact(int t, Visit&& visit) const {
    const int slot = candidates.slot_of(t);
    if (slot < 0) return 0;
    const SlotsView<V>& slots = candidates.slots();
    const V position = slots.position(slot);
    const Scalar<V> radius = slots.radius[slot];
    int tests = 0;
    candidates.for_each_range(slot, [&](const SlotRange& range) {
      tests += range.size();
      for (int s = range.first; s < range.last; ++s) {
        if (!slots.matches_tag(s, range)) continue;
        if (!kTests || in_contact(box.displacement(position, slots.position(s)), radius + slots.radius[s])) visit(s);
      }
    });
    return tests;
  }

  HOST_DEVICE int body_of(int t) const { return candidates.slots().body[candidates.slot_of(t)]; }

  /// Lower body first.
  HOST_DEVICE Pair pair_of(int a, int slot) const {
    const int b = candidates.slots().body[slot];
    return a < b ? Pair{a, b} : Pair{b, a};
  }
};

/// Kernel: counts the tests and the contacts of thread t.
template <class Tester>
struct CountContacts {
  Tester tester;
  Span<int> tested, found;
  Span<int> kept;  ///< kKept for each thread

  HOST_DEVICE void operator()(int t) const {
    int contacts = 0;
    tested[t] = tester.for_each_contact(t, [&](int other) {
      if (contacts < kKept) kept[int64_t(t) * kKept + contacts] = other;
      ++contacts;
      return true;
    });
    found[t] = contacts;
  }
};

/// Kernel: writes the pairs of thread t.
template <class Tester>
struct FillContacts {
  Tester tester;
  Span<const int> first, kept;
  Span<Pair> pairs;

  HOST_DEVICE void operator()(int t) const {
    const int begin = first[t], end = first[t + 1];
    if (begin == end) return;
    const int body = tester.body_of(t);
    if (end - begin <= kKept) {
      for (int k = 0; begin + k < end; ++k) pairs[begin + k] = tester.pair_of(body, kept[int64_t(t) * kKept + k]);
    } else {
      int filled = begin;
      tester.for_each_contact(t, [&](int other) {
        pairs[filled++] = tester.pair_of(body, other);
        return filled < end;
      });
    }
    if constexpr (Tester::kIsRow) sort_row(pairs.data() + begin, end - begin);
  }
};

template <class V, class Exec, bool kTests = true>
class KernelSearch {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// Throws RunError if there are too many contacts.
  template <class Candidates>
  void find(Exec& exec, const Candidates& candidates, const BodiesView<V>& bodies, const Box<V>& box,
            ContactRows<Exec>& rows) {
    if constexpr (GivesRanges<Candidates>) {
      find_by_thread(exec, RangeTester<V, Candidates, kTests>{candidates, box}, candidates.threads(), by_thread_);
      put_into_rows(exec, Span<const Pair>(by_thread_.pairs()), bodies.size(), rows);
    } else {
      find_by_thread(exec, ListTester<V, Candidates, kTests>{candidates, bodies, box}, bodies.size(), rows);
    }
  }

  Span<const int> tested() const { return tested_.span(); }  ///< the number of candidates that each thread tested
  int64_t tests(Exec& exec) const {
    return reduce(exec, "sum candidates", tested_.size(), int64_t{0}, ReadValue<int>{tested()}, Sum{});
  }
  int64_t bytes() const { return tested_.bytes() + found_.bytes() + kept_.bytes() + by_thread_.bytes(); }

 private:
  template <class Tester>
  void find_by_thread(Exec& exec, const Tester& tester, int64_t threads, ContactRows<Exec>& result) {
    tested_.resize(threads);
    found_.resize(threads);
    kept_.resize(threads * kKept);
    result.resize(threads, 0);
    exec.parallel_for("count contacts", threads,
                      CountContacts<Tester>{tester, tested_.span(), found_.span(), kept_.span()});
    const int64_t total = exec.exclusive_scan("scan contacts", found_.span(), result.first());
    result.resize_pairs(checked_count(total, kTests ? "contacts" : "candidates"));
    exec.parallel_for("fill contacts", threads,
                      FillContacts<Tester>{tester, result.first(), kept_.span(), result.pairs()});
  }

  Buffer<int> tested_, found_, kept_;
  ContactRows<Exec> by_thread_;
};

/// The candidates of a broad phase in canonical order, not tested, for the audience.
template <class V, class Exec, class Candidates>
std::vector<Pair> candidate_pairs(Exec& exec, const Candidates& candidates, const BodiesView<V>& bodies,
                                  const Box<V>& box) {
  KernelSearch<V, Exec, false> search;
  ContactRows<Exec> rows;
  search.find(exec, candidates, bodies, box, rows);
  return exec.download(rows.pairs());
}

}  // namespace ballpit
