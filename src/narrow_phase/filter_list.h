// SPDX-License-Identifier: MIT
// Finds the contacts among the pairs of a candidate list. The list is in canonical order, and so are the contacts.
//
//     list      (0,1) (0,3) (0,7) (2,5) (3,4)        each pair tested once
//     contacts  (0,3) (0,7) (2,5)
//     first     0 2 2 3 3 …                          where each body's row begins
//
// On the CPU in single precision, blocks of pairs are tested by vector instructions (range_tests.h); otherwise by the
// kernels of list_search.h. Cost: O(candidates + n).
#pragma once

#include <type_traits>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/pair.h"
#include "core/span.h"
#include "narrow_phase/candidate_list.h"
#include "narrow_phase/list_search.h"
#include "narrow_phase/range_tests.h"

namespace ballpit {

/// Tests by vector instructions.
template <class V>
class VectorListFilter {
 public:
  void find(CpuExecutor& exec, const ListedCandidates& list, const BodiesView<V>& bodies, const Box<V>& box,
            ContactRows<CpuExecutor>& rows) {
    const int64_t count = list.pairs.size(), blocks = (count + kBlock - 1) / kBlock;
    found_.start(exec, blocks);
    exec.parallel_for_blocks("test list", blocks, [&](int64_t b) {
      const int64_t first = b * kBlock, last = std::min(count, first + kBlock);
      test_pairs(bodies.position, bodies.radius, box, {list.pairs.data() + first, last - first}, found_.of(b));
    });
    const Span<const Pair> contacts = found_.join(exec);
    rows.resize(bodies.size(), contacts.size());
    std::copy(contacts.begin(), contacts.end(), rows.pairs().data());
    rows.first()[0] = 0;
    exec.parallel_for_blocks("note rows", (bodies.size() + kBlock - 1) / kBlock, [&](int64_t b) {
      note_rows(contacts, rows.first(), b * kBlock, std::min(bodies.size(), (b + 1) * kBlock));
    });
  }
  int64_t bytes() const { return found_.bytes(); }

 private:
  static constexpr int64_t kBlock = 1 << 14;  // pairs, or bodies

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

  PairBlocks found_;
};

template <class V, class Exec>
using ListFilter = std::conditional_t<kHasVectorTests<V, Exec>, VectorListFilter<V>, ListSearch<V, Exec>>;

}  // namespace ballpit
