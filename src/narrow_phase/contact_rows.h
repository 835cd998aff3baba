// SPDX-License-Identifier: MIT
// The result of a search: pairs in canonical order, in one row for each body i.
//
//     body    0  1  2  3
//     first   0  2  2  3  3
//     pairs   (0,3) (0,7) (2,5)       body i has pairs[first[i]] … pairs[first[i + 1] − 1]
#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include "bodies/contacts.h"
#include "core/error.h"
#include "exec/cpu_executor.h"
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

/// What the entries of a row are sorted by.
HOST_DEVICE inline int key(const Pair& pair) { return pair.j; }
HOST_DEVICE inline int key(const IncomingContact& incoming) { return incoming.contact; }

/// Sorts two pairs of one row, without a branch, which would be hard to predict.
HOST_DEVICE inline void order(Pair& a, Pair& b) {
  const Pair first = a, second = b;
  const bool is_swapped = second.j < first.j;
  a = {first.i, is_swapped ? second.j : first.j};
  b = {first.i, is_swapped ? first.j : second.j};
}

HOST_DEVICE inline void order(IncomingContact& a, IncomingContact& b) {
  if (!(b.contact < a.contact)) return;
  const IncomingContact first = a;
  a = b;
  b = first;
}

template <class Entry>
HOST_DEVICE void insert_all(Entry* row, int count) {
  for (int k = 1; k < count; ++k) {
    const Entry moved = row[k];
    int at = k;
    for (; at > 0 && key(row[at - 1]) > key(moved); --at) row[at] = row[at - 1];
    row[at] = moved;
  }
}

/// Moves row[at] down in a heap of `count` until none of its children is larger.
template <class Entry>
HOST_DEVICE void sink(Entry* row, int at, int count) {
  const Entry moved = row[at];
  for (int child = 2 * at + 1; child < count; child = 2 * at + 1) {
    if (child + 1 < count && key(row[child + 1]) > key(row[child])) ++child;
    if (key(row[child]) <= key(moved)) break;
    row[at] = row[child];
    at = child;
  }
  row[at] = moved;
}

template <class Entry>
HOST_DEVICE bool is_sorted(const Entry* row, int count) {
  for (int k = 1; k < count; ++k) {
    if (key(row[k - 1]) > key(row[k])) return false;
  }
  return true;
}

}  // namespace row_sorting

/// Sorts a row of `count` entries by their keys, on any processor: a short row, the usual case, by insertion, a long one by
/// heapsort, so that a body with thousands of contacts does not need millions of moves.
template <class Entry>
HOST_DEVICE void sort_row(Entry* row, int count) {
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
    const Entry largest = row[0];
    row[0] = row[last];
    row[last] = largest;
    sink(row, 0, last);
  }
}

/// Kernel: sorts the pairs of body i by j.
struct SortRow {
  Span<const int> first;
  Span<Pair> pairs;

  HOST_DEVICE void operator()(int i) const {
    const int begin = first[i], count = first[i + 1] - begin;
    if (count > 1) sort_row(pairs.data() + begin, count);
  }
};

template <class Exec>
class ContactRows {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  void resize(int64_t bodies, int64_t contacts) {
    first_.resize(bodies + 1);
    pairs_.resize(contacts);
    is_sorted_ = true;
    has_counts_ = false;
    is_exact_ = true;
  }
  void resize_pairs(int64_t contacts) { pairs_.resize(contacts); }

  // How row_search.h makes rows: count(), a kernel that counts, place(), and one that fills.

  void count(Exec& exec, int64_t bodies) {
    resize(bodies, 0);
    lower_first_.resize(bodies + 1);
    counts_.resize(2 * bodies);
    exec.clear(counts_.span());
  }

  /// Finds where rows begin, and makes room for the pairs; while the executor defers, as much as there was. `what` is
  /// counted; throws RunError if it is too much.
  void place(Exec& exec, const char* what) {
    const auto total = exec.exclusive_scan("scan contacts", higher(), lower(), first_.span(), lower_first_.span());
    if (exec.is_deferring()) {
      if constexpr (Exec::kDefers) pairs_.resize(pairs_.capacity());
      is_exact_ = false;
    } else {
      const int count = checked_count(total, what);
      if constexpr (Exec::kDefers) pairs_.resize(count + count / kSlack + kFew);
      pairs_.resize(count);
    }
    is_sorted_ = false;
    has_counts_ = true;
  }

  Span<int> higher() { return {counts_.span().data(), counts_.size() / 2}; }
  Span<int> lower() { return {counts_.span().data() + counts_.size() / 2, counts_.size() / 2}; }

  /// Where the contacts of each body with lower ones begin in their list; empty if that is not known.
  Span<const int> lower_first() const { return has_counts_ ? lower_first_.span() : Span<const int>(); }

  bool is_sorted() const { return is_sorted_; }

  /// Sorts the rows if they are not; unless the executor defers, pairs() has as many as there are afterwards.
  void sort(Exec& exec) {
    if (!is_exact_ && !exec.is_deferring()) {
      pairs_.resize(exec.download(Span<const int>(first_.span().end() - 1, 1))[0]);
      is_exact_ = true;
    }
    if (!is_sorted_) exec.parallel_for("sort rows", first_.size() - 1, SortRow{first(), pairs()});
    is_sorted_ = true;
  }

  /// Another kernel has sorted the rows, or used the counters `lower`, which are 0 afterwards.
  void note_sorted() { is_sorted_ = true; }
  void note_listed() { has_counts_ = false; }

  Span<int> first() { return first_.span(); }
  Span<Pair> pairs() { return pairs_.span(); }
  Span<const int> first() const { return first_.span(); }
  Span<const Pair> pairs() const { return pairs_.span(); }
  int64_t bytes() const { return first_.bytes() + pairs_.bytes() + lower_first_.bytes() + counts_.bytes(); }

 private:
  static constexpr int kSlack = 4, kFew = 256;  // room for a fourth more contacts, and some

  Buffer<int> first_, lower_first_;
  Buffer<Pair> pairs_;
  Buffer<int> counts_;  // of each body: contacts with higher ones, then those with lower ones
  bool is_sorted_ = true, is_exact_ = true, has_counts_ = false;
};

/// Key: the row that a pair belongs to.
struct RowOfPair {
  Span<const Pair> pairs;
  HOST_DEVICE int operator()(int k) const { return pairs[k].i; }
};

template <class Exec>
void sort_rows(Exec& exec, int64_t bodies, ContactRows<Exec>& rows) {
  exec.parallel_for("sort rows", bodies, SortRow{rows.first(), rows.pairs()});
}

/// Sorts the rows of bodies from … to − 1 by j as one array, since a loop for each row would end unpredictably. Of the
/// pairs read so far, `held` is the last one in order. So two pairs are exchanged without a branch, and only those that
/// belong farther ahead are inserted there.
inline void sort_rows_of(const int* first, Pair* pairs, int64_t from, int64_t to) {
  int longest = 0;
  for (int64_t i = from; i < to; ++i) longest = std::max(longest, first[i + 1] - first[i]);
  if (longest > row_sorting::kMaxInsertion) {
    for (int64_t i = from; i < to; ++i) sort_row(pairs + first[i], first[i + 1] - first[i]);
    return;
  }
  if (longest < 2) return;
  const auto key = [](const Pair& pair) { return uint64_t(unsigned(pair.i)) << 32 | unsigned(pair.j); };
  const auto pair_of = [](uint64_t value) { return Pair{int(value >> 32), int(value & 0xFFFFFFFFu)}; };
  Pair *const begin = pairs + first[from], *const end = pairs + first[to];
  uint64_t held = key(*begin), largest = 0;
  for (Pair* next = begin + 1; next != end; ++next) {
    const uint64_t read = key(*next), lower = read < held ? read : held;
    held = read < held ? held : read;
    Pair* at = next - 1;
    if (lower >= largest) {
      largest = lower;
    } else {
      for (; at != begin && key(at[-1]) > lower; --at) *at = at[-1];
    }
    *at = pair_of(lower);
  }
  end[-1] = pair_of(held);
}

inline void sort_rows(CpuExecutor& exec, int64_t bodies, ContactRows<CpuExecutor>& rows) {
  constexpr int64_t kBlock = 1 << 14;  // bodies
  const int* const first = rows.first().data();
  Pair* const pairs = rows.pairs().data();
  exec.parallel_for_blocks("sort rows", (bodies + kBlock - 1) / kBlock, [=](int64_t b) {
    sort_rows_of(first, pairs, b * kBlock, std::min(bodies, (b + 1) * kBlock));
  });
}

/// Sorts pairs (i < j) into canonical order.
template <class Exec>
void put_into_rows(Exec& exec, Span<const Pair> found, int64_t bodies, ContactRows<Exec>& rows) {
  rows.resize(bodies, found.size());
  exec.bin("sort contacts", RowOfPair{found}, ReadValue<Pair>{found}, rows.first(), rows.pairs());
  sort_rows(exec, bodies, rows);
}

}  // namespace ballpit
