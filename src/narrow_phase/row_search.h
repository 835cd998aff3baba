// SPDX-License-Identifier: MIT
// Tests the candidates of a broad phase where atomic operations are cheap, on a GPU, and writes the contacts in canonical
// order, by counters instead of sorting. The host need not know how many there are.
//
//     thread            0  1  2  3          kernel "count contacts": tests candidates, keeps the first kKept contacts,
//     contacts found    2  0  1  0          counts each for both of its bodies
//     first             0  2  2  3  3       scan, for the contacts of a body with higher ones, and with lower ones
//     pairs             (0,7) (0,3) (2,5)   kernel "fill contacts": each pair anywhere in its row
//     pairs             (0,3) (0,7) (2,5)   kernel "sort rows" (contact_list.h): each row by itself
//
// Only the order within a row depends on which thread comes first, and sorting removes that. If the pairs have too little
// room, the device halts (exec/deferred.h). Its sibling for the CPU is kernel_search.h, which has the testers.
#pragma once

#include "narrow_phase/kernel_search.h"

namespace ballpit {

/// Kernel: counts the tests and the contacts of thread t, and those of each body with higher and with lower ones.
template <class Tester>
struct CountInRows {
  Tester tester;
  Span<int> tested, found;
  Span<int> kept;  ///< kKept for each thread
  Span<int> higher, lower;

  HOST_DEVICE void operator()(int t) const {
    int contacts = 0;
    tested[t] = tester.for_each_contact(t, [&](int other) {
      if (contacts < kKept) kept[int64_t(t) * kKept + contacts] = other;
      ++contacts;
      const Pair pair = tester.pair_of(tester.body_of(t), other);
      atomic_add(&higher[pair.i], 1);
      atomic_add(&lower[pair.j], 1);
      return true;
    });
    found[t] = contacts;
  }
};

/// Kernel: writes the pairs of thread t. The counters `higher` are 0 afterwards.
template <class Tester>
struct FillRows {
  Tester tester;
  Span<const int> found, kept, first;
  Span<int> higher;
  Span<Pair> pairs;
  Halt halt;

  HOST_DEVICE void operator()(int t) const {
    if (first[first.size() - 1] > pairs.size()) {
      if (t == 0) halt.raise();
      return;
    }
    const int contacts = found[t];
    if (contacts == 0) return;
    const int body = tester.body_of(t);
    if (contacts <= kKept) {
      for (int k = 0; k < contacts; ++k) write(tester.pair_of(body, kept[int64_t(t) * kKept + k]));
    } else {
      int filled = 0;
      tester.for_each_contact(t, [&](int other) {
        write(tester.pair_of(body, other));
        return ++filled < contacts;
      });
    }
  }

 private:
  HOST_DEVICE void write(const Pair& pair) const { pairs[first[pair.i] + atomic_add(&higher[pair.i], -1) - 1] = pair; }
};

template <class V, class Exec, bool kTests = true>
class RowSearch {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// Rows are not sorted yet. Throws RunError if there are too many contacts.
  template <class Candidates>
  void find(Exec& exec, const Candidates& candidates, const BodiesView<V>& bodies, const Box<V>& box,
            ContactRows<Exec>& rows) {
    if constexpr (GivesRanges<Candidates>) {
      find_by(exec, RangeTester<V, Candidates, kTests>{candidates, box}, candidates.threads(), bodies.size(), rows);
    } else {
      find_by(exec, ListTester<V, Candidates, kTests>{candidates, bodies, box}, bodies.size(), bodies.size(), rows);
    }
  }

  Span<const int> tested() const { return tested_.span(); }  ///< the number of candidates that each thread tested
  int64_t tests(Exec& exec) const {
    return reduce(exec, "sum candidates", tested_.size(), int64_t{0}, ReadValue<int>{tested()}, Sum{});
  }
  int64_t bytes() const { return tested_.bytes() + found_.bytes() + kept_.bytes(); }

 private:
  template <class Tester>
  void find_by(Exec& exec, const Tester& tester, int64_t threads, int64_t bodies, ContactRows<Exec>& rows) {
    tested_.resize(threads);
    found_.resize(threads);
    kept_.resize(threads * kKept);
    rows.count(exec, bodies);
    exec.parallel_for(
        "count contacts", threads,
        CountInRows<Tester>{tester, tested_.span(), found_.span(), kept_.span(), rows.higher(), rows.lower()});
    rows.place(exec, kTests ? "contacts" : "candidates");
    exec.parallel_for(
        "fill contacts", threads,
        FillRows<Tester>{tester, found_.span(), kept_.span(), rows.first(), rows.higher(), rows.pairs(), exec.halt()});
  }

  Buffer<int> tested_, found_, kept_;
};

}  // namespace ballpit
