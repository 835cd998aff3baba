// SPDX-License-Identifier: MIT
// Finds contacts on the CPU in single precision, by vector instructions (range_tests.h), and chooses between them and
// the kernels of kernel_search.h, or on a GPU those of row_search.h.
//
//     candidates in ranges    blocks of slots, tested at once; pairs in any order, sorted into rows afterwards
//     a candidate list        blocks of pairs; the list is in canonical order, and so are the contacts
//
//         list      (0,1) (0,3) (0,7) (2,5) (3,4)        each pair tested once
//         contacts  (0,3) (0,7) (2,5)
//         first     0 2 2 3 3 …                          where each body's row begins
//
// Cost: one pass over the candidates; O(contacts + n) to sort them.
#pragma once

#include <numeric>

#include "broad_phase/sorted_grid.h"
#include "narrow_phase/candidate_list.h"
#include "narrow_phase/cell_tests.h"
#include "narrow_phase/kernel_search.h"
#include "narrow_phase/range_tests.h"
#include "narrow_phase/row_search.h"

namespace ballpit {

template <class V>
class VectorSearch {
 public:
  template <GivesRanges Candidates>
  void find(CpuExecutor& exec, const Candidates& candidates, const BodiesView<V>& bodies, const Box<V>& box,
            ContactRows<CpuExecutor>& rows) {
    const int64_t slots = candidates.slots().count, blocks = (slots + kSlotBlock - 1) / kSlotBlock;
    found_.start(exec, blocks, kSlotBlock);
    tested_.assign(static_cast<size_t>(blocks), 0);
    exec.parallel_for_blocks("test ranges", blocks, [&](int64_t b) {
      const int first = static_cast<int>(b * kSlotBlock),
                last = static_cast<int>(std::min(slots, (b + 1) * kSlotBlock));
      tested_[static_cast<size_t>(b)] = search(candidates, box, first, last, found_.of(b));
    });
    put_into_rows(exec, found_.join(exec), bodies.size(), rows);
  }

  void find(CpuExecutor& exec, const ListedCandidates& list, const BodiesView<V>& bodies, const Box<V>& box,
            ContactRows<CpuExecutor>& rows) {
    const int64_t count = list.pairs.size(), blocks = (count + kPairBlock - 1) / kPairBlock;
    found_.start(exec, blocks, 0);
    exec.parallel_for_blocks("test list", blocks, [&](int64_t b) {
      const int64_t first = b * kPairBlock, last = std::min(count, first + kPairBlock);
      vector_tests<V>().test_pairs(bodies.position, bodies.radius, box, {list.pairs.data() + first, last - first},
                                   found_.of(b));
    });
    found_.join(exec, bodies.size(), rows);
    const Span<const Pair> contacts = rows.pairs();
    rows.first()[0] = 0;
    exec.parallel_for_blocks("note rows", (bodies.size() + kPairBlock - 1) / kPairBlock, [&](int64_t b) {
      note_rows(contacts, rows.first(), b * kPairBlock, std::min(bodies.size(), (b + 1) * kPairBlock));
    });
  }

  /// The number of tests in ranges.
  int64_t tests() const { return std::accumulate(tested_.begin(), tested_.end(), int64_t(0)); }
  int64_t bytes() const { return found_.bytes(); }

 private:
  static constexpr int64_t kSlotBlock = 2048;
  static constexpr int64_t kPairBlock = 1 << 14;  // pairs, or bodies
  static constexpr int kTasks = 512;              // fit into the nearest cache

  /// Returns the number of tests.
  static int64_t test(const SlotsView<V>& slots, const Box<V>& box, Span<const RangeTask> tasks, PairBuffer& found) {
    vector_tests<V>().test_ranges(slots, box, tasks, found);
    int64_t tested = 0;
    for (const RangeTask& task : tasks) tested += task.range.last - task.range.first;
    return tested;
  }

  /// The same for slots from … to − 1.
  template <class Candidates>
  static int64_t search(const Candidates& candidates, const Box<V>& box, int from, int to, PairBuffer& found) {
    return test_ranges(candidates, box, found,
                       [=](const Candidates& local, const auto& visit) { local.for_each_range_of(from, to, visit); });
  }

  /// In a sorted grid class by class, cells of dense grids by vectors.
  static int64_t search(const SortedGridCandidates<V>& candidates, const Box<V>& box, int from, int to,
                        PairBuffer& found) {
    const DenseCells<V> cells{candidates.grids, candidates.offsets, candidates.slots_view};
    int64_t tested = 0;
    candidates.for_each_class(from, to, [&](int own, int first, int last) {
      for (int k = own; k < candidates.grids.count; ++k) {
        if (candidates.grids.is_dense(k)) {
          tested += cell_tests<V>()(cells, own, k, first, last, found);
          continue;
        }
        tested += test_ranges(candidates, box, found, [=](const auto& local, const auto& visit) {
          for (int slot = first; slot < last; ++slot) {
            local.for_each_range_in(k, slot, own, [&](const SlotRange& range) { visit(slot, range); });
          }
        });
      }
    });
    return tested;
  }

  /// Tests the ranges that for_each(candidates, visit) visits. A local copy of the candidates, which no pointer can
  /// alias, stays in registers, as in CpuExecutor's kernels.
  template <class Candidates, class ForEach>
  [[gnu::flatten]] static int64_t test_ranges(const Candidates& shared, const Box<V>& box, PairBuffer& found,
                                              const ForEach& for_each) {
    const Candidates candidates = shared;
    RangeTask tasks[kTasks];
    int count = 0;
    int64_t tested = 0;
    for_each(candidates, [&](int slot, const SlotRange& range) {
      tasks[count] = {slot, range};  // if empty, the next one overwrites it: saves an unpredictable branch
      count += range.first < range.last;
      if (count == kTasks) {
        tested += test(candidates.slots(), box, {tasks, count}, found);
        count = 0;
      }
    });
    return tested + test(candidates.slots(), box, {tasks, count}, found);
  }

  /// Writes where the rows of bodies `from` … `to` − 1 end. Avoids a branch for each body, since its number of contacts
  /// is hard to predict: each pair writes the end of its row, the last one remains, and bodies without pairs copy the
  /// end of the row before.
  static void note_rows(Span<const Pair> pairs, Span<int> first, int64_t from, int64_t to) {
    const auto before = [](const Pair& pair, int64_t body) { return pair.i < body; };
    const Pair* pair = std::lower_bound(pairs.begin(), pairs.end(), from, before);
    const Pair* const last = std::lower_bound(pair, pairs.end(), to, before);
    int end = static_cast<int>(pair - pairs.begin());
    std::fill(first.data() + from + 1, first.data() + to + 1, end);
    for (; pair != last; ++pair) first[pair->i + 1] = static_cast<int>(pair - pairs.begin()) + 1;
    for (int64_t body = from; body < to; ++body) first[body + 1] = end = std::max(end, first[body + 1]);
  }

  std::vector<int64_t> tested_;  // by each block
  PairBlocks found_;
};

/// Tests candidates by vectors where there are tests for them, else by kernels.
template <class V, class Exec>
class Search {
 public:
  template <class Candidates>
  void find(Exec& exec, const Candidates& candidates, const BodiesView<V>& bodies, const Box<V>& box,
            ContactRows<Exec>& rows) {
    if constexpr (kByVectors<Candidates>) {
      vectors_.find(exec, candidates, bodies, box, rows);
    } else {
      kernels_.find(exec, candidates, bodies, box, rows);
    }
  }

  /// The number of tests of the last search in such candidates.
  template <class Candidates>
  int64_t tests(Exec& exec) const {
    if constexpr (kByVectors<Candidates>)
      return vectors_.tests();
    else
      return kernels_.tests(exec);
  }

  Span<const int> tested() const { return kernels_.tested(); }  ///< by each of the kernels' threads
  int64_t bytes() const { return kernels_.bytes() + vectors_.bytes(); }

 private:
  template <class Candidates>
  static constexpr bool kByVectors = kHasVectorTests<V, Exec> &&
                                     (GivesRanges<Candidates> || std::is_same_v<Candidates, ListedCandidates>);

  std::conditional_t<Exec::kDefers, RowSearch<V, Exec>, KernelSearch<V, Exec>> kernels_;
  VectorSearch<V> vectors_;
};

}  // namespace ballpit
