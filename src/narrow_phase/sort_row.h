// SPDX-License-Identifier: MIT
// Sorts a row of contacts in place, on any processor: a short row, the usual case, by insertion, a long one by
// heapsort, so that a body with thousands of contacts does not need millions of moves.
#pragma once

#include "bodies/pair.h"
#include "core/span.h"

namespace ballpit {

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

/// Sorts `count` pairs by j.
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

}  // namespace ballpit
