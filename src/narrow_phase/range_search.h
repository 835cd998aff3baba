// SPDX-License-Identifier: MIT
// From ranges of candidates to contacts in canonical order.
//
//     thread            0        1       2           one thread a slot: count its contacts, keep the first kKept
//     found             (3,0)    –       (1,2) (1,4)  scan, fill: pairs in the order of the slots
//     pairs   (0,3) (1,2) (1,4)                       sorted by i (a counting sort), each row by j
//
// On the CPU in single precision, blocks of slots are searched by vector instructions (range_tests.h) in place of count, scan and fill.
// Cost: one pass over the candidates, or two for threads with more contacts than are kept; O(contacts + n) to order them.
// Sibling for candidates in lists: list_search.h.
#pragma once

#include <algorithm>
#include <numeric>
#include <type_traits>
#include <vector>

#include "bodies/box.h"
#include "bodies/pair.h"
#include "bodies/slots.h"
#include "core/span.h"
#include "exec/cpu_executor.h"
#include "exec/reduce.h"
#include "narrow_phase/contact_rows.h"
#include "narrow_phase/range_tests.h"

namespace ballpit {

/// Calls visit(slot) for each slot of a range that `slot` touches, until visit returns false; counts the tests.
template <class V, class Candidates, class Visit>
HOST_DEVICE void visit_touching(const Candidates& candidates, const Box<V>& box, int slot, int& tests, Visit&& visit) {
  const SlotsView<V>& slots = candidates.slots();
  const V position = slots.position(slot);
  const Scalar<V> radius = slots.radius[slot];
  candidates.for_each_range(slot, [&](const SlotRange& range) {
    tests += range.size();
    for (int s = range.first; s < range.last; ++s) {
      if (!slots.is_meant(s, range)) continue;
      if (in_contact(box.displacement(position, slots.position(s)), radius + slots.radius[s])) visit(s);
    }
  });
}

/// Kernel: counts what thread t tests and finds.
template <class V, class Candidates>
struct CountInRanges {
  Candidates candidates;
  Box<V> box;
  Span<int> tested, found;
  Span<int> kept;  ///< kKept a thread

  HOST_DEVICE void operator()(int t) const {
    int tests = 0, contacts = 0;
    if (const int slot = candidates.slot_of(t); slot >= 0) {
      visit_touching(candidates, box, slot, tests, [&](int s) {
        if (contacts < kKept) kept[int64_t(t) * kKept + contacts] = s;
        ++contacts;
      });
    }
    tested[t] = tests;
    found[t] = contacts;
  }
};

/// Kernel: writes the pairs of thread t, lower body first.
template <class V, class Candidates>
struct FillFromRanges {
  Candidates candidates;
  Box<V> box;
  Span<const int> first, kept;
  Span<Pair> pairs;

  HOST_DEVICE void operator()(int t) const {
    const int begin = first[t], count = first[t + 1] - begin;
    if (count == 0) return;
    const int slot = candidates.slot_of(t);
    const Span<const int> body = candidates.slots().body;
    if (count <= kKept) {
      for (int k = 0; k < count; ++k) pairs[begin + k] = ordered(body[slot], body[kept[int64_t(t) * kKept + k]]);
      return;
    }
    int tests = 0, filled = begin;
    visit_touching(candidates, box, slot, tests, [&](int s) { pairs[filled++] = ordered(body[slot], body[s]); });
  }

  HOST_DEVICE static Pair ordered(int a, int b) { return a < b ? Pair{a, b} : Pair{b, a}; }
};

/// Finds the pairs in contact, each once, in any order: by kernels, on any executor.
template <class V, class Exec>
class KernelRangeSearch {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  template <class Candidates>
  void find(Exec& exec, const Candidates& candidates, const Box<V>& box) {
    const int64_t threads = candidates.threads();
    tested_.resize(threads);
    found_.resize(threads);
    first_.resize(threads + 1);
    kept_.resize(threads * kKept);
    exec.parallel_for("count contacts", threads,
                      CountInRanges<V, Candidates>{candidates, box, tested_.span(), found_.span(), kept_.span()});
    const int64_t total = exec.exclusive_scan("scan contacts", found_.span(), first_.span());
    pairs_.resize(checked_count(total, "contacts"));
    exec.parallel_for("fill contacts", threads,
                      FillFromRanges<V, Candidates>{candidates, box, first_.span(), kept_.span(), pairs_.span()});
  }

  Span<const Pair> pairs() const { return pairs_.span(); }
  int64_t candidates(Exec& exec) const { return sum_of(exec, tested_.span()); }
  int64_t bytes() const { return tested_.bytes() + found_.bytes() + first_.bytes() + kept_.bytes() + pairs_.bytes(); }

 private:
  Buffer<int> tested_, found_, first_, kept_;
  Buffer<Pair> pairs_;
};

/// The same on the CPU in single precision, by vector instructions.
template <class V>
class VectorRangeSearch {
 public:
  template <class Candidates>
  void find(CpuExecutor& exec, const Candidates& candidates, const Box<V>& box) {
    const int64_t slots = candidates.slots().count, blocks = (slots + kBlock - 1) / kBlock;
    found_.start(exec, blocks);
    tested_.assign(static_cast<size_t>(blocks), 0);
    exec.parallel_for_blocks("test ranges", blocks, [&](int64_t b) {
      const int last = static_cast<int>(std::min(slots, (b + 1) * kBlock));
      tested_[static_cast<size_t>(b)] = search(candidates, box, static_cast<int>(b * kBlock), last, found_.of(b));
    });
    pairs_ = found_.join(exec);
  }

  Span<const Pair> pairs() const { return pairs_; }

  int64_t candidates(CpuExecutor&) const { return std::accumulate(tested_.begin(), tested_.end(), int64_t(0)); }

  int64_t bytes() const { return found_.bytes(); }

 private:
  static constexpr int64_t kBlock = 2048;  // slots
  static constexpr int kTasks = 512;       // that fit the nearest cache

  /// Returns the number of tests.
  static int64_t test(const SlotsView<V>& slots, const Box<V>& box, Span<const RangeTask> tasks, PairBuffer& found) {
    test_ranges(slots, box, tasks, found);
    int64_t tested = 0;
    for (const RangeTask& task : tasks) tested += task.range.last - task.range.first;
    return tested;
  }

  /// The same for slots from … to − 1. A copy of the candidates that nothing else can point to stays in registers, as
  /// CpuExecutor's kernels do.
  template <class Candidates>
  [[gnu::flatten]] static int64_t search(const Candidates& shared, const Box<V>& box, int from, int to,
                                         PairBuffer& found) {
    const Candidates candidates = shared;
    RangeTask tasks[kTasks];
    int count = 0;
    int64_t tested = 0;
    candidates.for_each_range_of(from, to, [&](int slot, const SlotRange& range) {
      tasks[count] = {slot, range};  // overwritten by the next where it is empty: that is hard to predict
      count += range.first < range.last;
      if (count == kTasks) {
        tested += test(candidates.slots(), box, {tasks, count}, found);
        count = 0;
      }
    });
    return tested + test(candidates.slots(), box, {tasks, count}, found);
  }

  std::vector<int64_t> tested_;  // in each block
  PairBlocks found_;
  Span<const Pair> pairs_;
};

template <class V, class Exec>
struct RangeSearchOn {
  using Type = KernelRangeSearch<V, Exec>;
};
template <class V>
requires std::is_same_v < Scalar<V>,
float > struct RangeSearchOn<V, CpuExecutor> { using Type = VectorRangeSearch<V>; };

/// Finds contacts in ranges and puts them into rows. `rows` receives them.
template <class V, class Exec>
class RangeSearch {
 public:
  template <class Candidates>
  void find(Exec& exec, const Candidates& candidates, const Box<V>& box, int64_t bodies, ContactRows<Exec>& rows) {
    search_.find(exec, candidates, box);
    put_into_rows(exec, search_.pairs(), bodies, rows);
  }

  int64_t candidates(Exec& exec) const { return search_.candidates(exec); }
  int64_t bytes() const { return search_.bytes(); }

 private:
  typename RangeSearchOn<V, Exec>::Type search_;
};

}  // namespace ballpit
