// SPDX-License-Identifier: MIT
// Tests the candidates in ranges and writes the contacts in canonical order.
//
//     thread            0        1       2            one thread per slot: counts its contacts, keeps the first kKept
//     found             (3,0)    –       (1,2) (1,4)  scan, fill: pairs in the order of the slots
//     pairs   (0,3) (1,2) (1,4)                       sorted by i (a counting sort), each row by j
//
// On the CPU in single precision, vector instructions search blocks of slots instead (range_tests.h).
// Cost: one pass over the candidates, two for threads with more contacts than are kept; O(contacts + n) to sort them.
// Its sibling for candidates in lists is list_search.h.
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

/// Calls visit(s) for each candidate s that `slot` touches; adds the number of tests to `tests`.
template <class V, class Candidates, class Visit>
HOST_DEVICE void visit_touching(const Candidates& candidates, const Box<V>& box, int slot, int& tests, Visit&& visit) {
  const SlotsView<V>& slots = candidates.slots();
  const V position = slots.position(slot);
  const Scalar<V> radius = slots.radius[slot];
  candidates.for_each_range(slot, [&](const SlotRange& range) {
    tests += range.size();
    for (int s = range.first; s < range.last; ++s) {
      if (!slots.matches_tag(s, range)) continue;
      if (in_contact(box.displacement(position, slots.position(s)), radius + slots.radius[s])) visit(s);
    }
  });
}

/// Kernel: counts the tests and the contacts of thread t.
template <class V, class Candidates>
struct CountInRanges {
  Candidates candidates;
  Box<V> box;
  Span<int> tested, found;
  Span<int> kept;  ///< kKept for each thread

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

/// Finds the pairs in contact, in any order, by kernels on any executor.
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
  static constexpr int kTasks = 512;       // fit into the nearest cache

  /// Returns the number of tests.
  static int64_t test(const SlotsView<V>& slots, const Box<V>& box, Span<const RangeTask> tasks, PairBuffer& found) {
    test_ranges(slots, box, tasks, found);
    int64_t tested = 0;
    for (const RangeTask& task : tasks) tested += task.range.last - task.range.first;
    return tested;
  }

  /// The same for slots from … to − 1. A local copy of the candidates, which no pointer can alias, stays in registers,
  /// as in CpuExecutor's kernels.
  template <class Candidates>
  [[gnu::flatten]] static int64_t search(const Candidates& shared, const Box<V>& box, int from, int to,
                                         PairBuffer& found) {
    const Candidates candidates = shared;
    RangeTask tasks[kTasks];
    int count = 0;
    int64_t tested = 0;
    candidates.for_each_range_of(from, to, [&](int slot, const SlotRange& range) {
      tasks[count] = {slot, range};  // if empty, the next one overwrites it: saves an unpredictable branch
      count += range.first < range.last;
      if (count == kTasks) {
        tested += test(candidates.slots(), box, {tasks, count}, found);
        count = 0;
      }
    });
    return tested + test(candidates.slots(), box, {tasks, count}, found);
  }

  std::vector<int64_t> tested_;  // by each block
  PairBlocks found_;
  Span<const Pair> pairs_;
};

/// Finds the contacts in ranges and sorts them into `rows`.
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
  std::conditional_t<kHasVectorTests<V, Exec>, VectorRangeSearch<V>, KernelRangeSearch<V, Exec>> search_;
};

}  // namespace ballpit
