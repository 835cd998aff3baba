// SPDX-License-Identifier: MIT
// Lists all candidates of a broad phase without testing them, for the audience.
//
//     thread            0        1       2
//     candidates        (3,0)    –       (1,2) (1,4)   count, scan, fill: pairs in the order of the threads
//     pairs   (0,3) (1,2) (1,4)                        in canonical order
//
// Cost: two passes over the candidates; 16 bytes for each while they are sorted.
// Siblings that test candidates: list_search.h, range_search.h.
#pragma once

#include <vector>

#include "bodies/pair.h"
#include "bodies/slots.h"
#include "core/span.h"
#include "narrow_phase/contact_rows.h"

namespace ballpit {

/// Calls visit(a, b) for each candidate pair of thread t: for lists those of body t, for ranges those of one slot.
template <class Candidates, class Visit>
HOST_DEVICE void visit_candidates(const Candidates& candidates, int t, Visit&& visit) {
  if constexpr (GivesRanges<Candidates>) {
    const int slot = candidates.slot_of(t);
    if (slot < 0) return;
    const auto& slots = candidates.slots();
    candidates.for_each_range(slot, [&](const SlotRange& range) {
      for (int s = range.first; s < range.last; ++s) {
        if (slots.matches_tag(s, range)) visit(slots.body[slot], slots.body[s]);
      }
    });
  } else {
    candidates.for_each(t, [&](int j) {
      visit(t, j);
      return true;
    });
  }
}

/// Kernel: counts the candidates of thread t.
template <class Candidates>
struct CountCandidates {
  Candidates candidates;
  Span<int> count;

  HOST_DEVICE void operator()(int t) const {
    int sum = 0;
    visit_candidates(candidates, t, [&](int, int) { ++sum; });
    count[t] = sum;
  }
};

/// Kernel: writes the candidates of thread t, lower body first.
template <class Candidates>
struct FillCandidates {
  Candidates candidates;
  Span<const int> first;
  Span<Pair> pairs;

  HOST_DEVICE void operator()(int t) const {
    int filled = first[t];
    visit_candidates(candidates, t, [&](int a, int b) { pairs[filled++] = a < b ? Pair{a, b} : Pair{b, a}; });
  }
};

/// The candidates of a broad phase, prepared for this number of bodies. Throws RunError if there are too many.
template <class Exec, class Candidates>
std::vector<Pair> candidate_pairs(Exec& exec, const Candidates& candidates, int64_t bodies) {
  int64_t threads = bodies;
  if constexpr (GivesRanges<Candidates>) threads = candidates.threads();
  typename Exec::template Buffer<int> count, first;
  typename Exec::template Buffer<Pair> pairs;
  count.resize(threads);
  first.resize(threads + 1);
  exec.parallel_for("count candidates", threads, CountCandidates<Candidates>{candidates, count.span()});
  const int64_t total = exec.exclusive_scan("scan candidates", count.span(), first.span());
  pairs.resize(checked_count(total, "candidates"));
  exec.parallel_for("fill candidates", threads, FillCandidates<Candidates>{candidates, first.span(), pairs.span()});
  ContactRows<Exec> rows;
  put_into_rows(exec, Span<const Pair>(pairs.span()), bodies, rows);
  return exec.download(rows.pairs());
}

}  // namespace ballpit
