// SPDX-License-Identifier: MIT
// The result of a search: pairs in canonical order, in one row for each body i.
//
//     body    0  1  2  3
//     first   0  2  2  3  3
//     pairs   (0,3) (0,7) (2,5)       body i has pairs[first[i]] … pairs[first[i + 1] − 1]
#pragma once

#include <limits>
#include <string>

#include "bodies/pair.h"
#include "core/error.h"
#include "exec/reduce.h"

namespace ballpit {

/// `count` as an index. Throws RunError if it is too large for one.
inline int checked_count(int64_t count, const char* what) {
  if (count > std::numeric_limits<int>::max()) {
    throw RunError(what, "too many: " + std::to_string(count),
                   "at most " + std::to_string(std::numeric_limits<int>::max()) + " can be held");
  }
  return static_cast<int>(count);
}

namespace row_sorting {

inline constexpr int kMaxInsertion = 48;

/// Sorts two pairs of one row, without a branch, which would be hard to predict.
HOST_DEVICE inline void order(Pair& a, Pair& b) {
  const Pair first = a, second = b;
  const bool is_swapped = second.j < first.j;
  a = {first.i, is_swapped ? second.j : first.j};
  b = {first.i, is_swapped ? first.j : second.j};
}

HOST_DEVICE inline void insert_all(Pair* row, int count) {
  for (int k = 1; k < count; ++k) {
    const Pair moved = row[k];
    int at = k;
    for (; at > 0 && row[at - 1].j > moved.j; --at) row[at] = row[at - 1];
    row[at] = moved;
  }
}

/// Moves row[at] down in a heap of `count` until none of its children is larger.
HOST_DEVICE inline void sink(Pair* row, int at, int count) {
  const Pair moved = row[at];
  for (int child = 2 * at + 1; child < count; child = 2 * at + 1) {
    if (child + 1 < count && row[child + 1].j > row[child].j) ++child;
    if (row[child].j <= moved.j) break;
    row[at] = row[child];
    at = child;
  }
  row[at] = moved;
}

HOST_DEVICE inline bool is_sorted(const Pair* row, int count) {
  for (int k = 1; k < count; ++k) {
    if (row[k - 1].j > row[k].j) return false;
  }
  return true;
}

}  // namespace row_sorting

/// Sorts `count` pairs of a row by j, on any processor: a short row, the usual case, by insertion, a long one by
/// heapsort, so that a body with thousands of contacts does not need millions of moves.
HOST_DEVICE inline void sort_row(Pair* row, int count) {
  using namespace row_sorting;
  if (count == 2) {
    order(row[0], row[1]);
    return;
  }
  if (count == 3) {
    order(row[0], row[1]);
    order(row[1], row[2]);
    order(row[0], row[1]);
    return;
  }
  if (count <= kMaxInsertion) {
    insert_all(row, count);
    return;
  }
  if (is_sorted(row, count)) return;
  for (int at = count / 2 - 1; at >= 0; --at) sink(row, at, count);
  for (int last = count - 1; last > 0; --last) {
    const Pair largest = row[0];
    row[0] = row[last];
    row[last] = largest;
    sink(row, 0, last);
  }
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
