// SPDX-License-Identifier: MIT
// The result of a search: pairs in canonical order, in one row for each body i.
//
//     body    0  1  2  3
//     first   0  2  2  3  3
//     pairs   (0,3) (0,7) (2,5)       body i has pairs[first[i]] … pairs[first[i + 1] − 1]
#pragma once

#include <limits>
#include <string>

#include "core/error.h"
#include "exec/reduce.h"
#include "narrow_phase/sort_row.h"

namespace ballpit {

/// `count` as an index. Throws RunError if it is too large for one.
inline int checked_count(int64_t count, const char* what) {
  if (count > std::numeric_limits<int>::max()) {
    throw RunError(what, "too many: " + std::to_string(count),
                   "at most " + std::to_string(std::numeric_limits<int>::max()) + " can be held");
  }
  return static_cast<int>(count);
}

template <class Exec>
class ContactRows {
 public:
  void resize(int64_t bodies, int64_t contacts) {
    first_.resize(bodies + 1);
    pairs_.resize(contacts);
  }
  void resize_pairs(int64_t contacts) { pairs_.resize(contacts); }

  Span<int> first() { return first_.span(); }
  Span<Pair> pairs() { return pairs_.span(); }
  Span<const int> first() const { return first_.span(); }
  Span<const Pair> pairs() const { return pairs_.span(); }
  int64_t bytes() const { return first_.bytes() + pairs_.bytes(); }

 private:
  typename Exec::template Buffer<int> first_;
  typename Exec::template Buffer<Pair> pairs_;
};

/// Key: the row that a pair belongs to.
struct RowOfPair {
  Span<const Pair> pairs;
  HOST_DEVICE int operator()(int k) const { return pairs[k].i; }
};

/// Kernel: sorts the pairs of body i by j.
struct SortRow {
  Span<const int> first;
  Span<Pair> pairs;

  HOST_DEVICE void operator()(int i) const {
    const int begin = first[i], count = first[i + 1] - begin;
    if (count > 1) sort_row(pairs.data() + begin, count);
  }
};

/// Sorts pairs (i < j) into canonical order.
template <class Exec>
void put_into_rows(Exec& exec, Span<const Pair> found, int64_t bodies, ContactRows<Exec>& rows) {
  rows.resize(bodies, found.size());
  exec.bin("sort contacts", RowOfPair{found}, ReadValue<Pair>{found}, rows.first(), rows.pairs());
  exec.parallel_for("sort rows", bodies, SortRow{rows.first(), rows.pairs()});
}

}  // namespace ballpit
