// SPDX-License-Identifier: MIT
// reduce: combines many values to one, in an order that only depends on the indices. So sums of floating-point numbers
// are bit-identical for any number of threads, and on CPU and GPU.
//
//     values   0 1 2 … 63 | 64 … 127 | …      one thread combines a block of 64 from left to right
//     partial  0            1          …      repeated until one value is left
//
// Cost: n combinations, log₆₄ n launches. any(), which tests a predicate for all indices, needs no order: one launch on
// a GPU.
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>

#include "core/span.h"
#include "exec/atomics.h"
#include "exec/deferred.h"

namespace ballpit {

inline constexpr int64_t kReduceBlock = 64;

/// Combine: a + b.
struct Sum {
  template <class T, class U>
  HOST_DEVICE T operator()(const T& a, const U& b) const {
    return a + b;
  }
};

/// Combine: whether one of them is true. Without a branch, so that loops become vector instructions.
struct Or {
  HOST_DEVICE int operator()(int a, int b) const { return a | b; }
};

/// Kernel: combines one block of map(i).
template <class T, class Map, class Combine>
struct ReduceBlock {
  Map map;
  Combine combine;
  T identity;
  int64_t n;
  Span<T> partial;

  HOST_DEVICE void operator()(int block) const {
    const int64_t first = block * kReduceBlock, end = first + kReduceBlock < n ? first + kReduceBlock : n;
    const int last = static_cast<int>(end);
    T result = identity;
    if constexpr (std::is_same_v<Combine, Or>) {
#pragma omp simd reduction(| : result)
      for (int i = static_cast<int>(first); i < last; ++i) result |= map(i);
    } else {
      for (int i = static_cast<int>(first); i < last; ++i) result = combine(result, map(i));
    }
    partial[block] = result;
  }
};

/// Map or key: the i-th value of an array.
template <class T>
struct ReadValue {
  Span<const T> values;
  HOST_DEVICE T operator()(int i) const { return values[i]; }
};

/// combine(… combine(combine(identity, map(0)), map(1)) …) over i in 0 … n−1, block by block. Partial results are in
/// the executor's scratch memory, so that a reduction in every step allocates nothing.
template <class Exec, class T, class Map, class Combine>
T reduce(Exec& exec, const char* name, int64_t n, T identity, Map map, Combine combine) {
  if (n == 0) return identity;
  const auto blocks = [](int64_t count) { return (count + kReduceBlock - 1) / kReduceBlock; };
  Span<T> current = exec.template scratch<T>(0, blocks(n));
  Span<T> next = exec.template scratch<T>(1, blocks(blocks(n)));
  exec.parallel_for(name, current.size(), ReduceBlock<T, Map, Combine>{map, combine, identity, n, current});
  while (current.size() > 1) {
    next = {next.data(), blocks(current.size())};
    exec.parallel_for(name, next.size(),
                      ReduceBlock<T, ReadValue<T>, Combine>{{current}, combine, identity, current.size(), next});
    std::swap(current, next);
  }
  return exec.download(current)[0];
}

/// Kernel: raises the flag if predicate(i).
template <class Predicate>
struct RaiseFlag {
  Predicate predicate;
  Span<int> flag;

  HOST_DEVICE void operator()(int i) const {
    if (predicate(i)) atomic_exchange(&flag[0], 1);
  }
};

/// Whether predicate(i) for any i in 0 … n−1. Uses scratch memory, as reduce() does.
template <class Exec, class Predicate>
bool any(Exec& exec, const char* name, int64_t n, const Predicate& predicate) {
  if (n == 0) return false;
  if constexpr (!Exec::kDefers) return reduce(exec, name, n, 0, predicate, Or{}) != 0;
  const Span<int> flag = exec.template scratch<int>(0, 1);
  exec.fill("lower flag", flag, 0);
  exec.parallel_for(name, n, RaiseFlag<Predicate>{predicate, flag});
  return exec.download(flag)[0] != 0;
}

/// The same for a condition that ends the run. While the executor defers, the answer is false, and the device halts.
template <class Exec, class Predicate>
bool stops_if(Exec& exec, const char* name, int64_t n, const Predicate& predicate) {
  if (!exec.is_deferring()) return any(exec, name, n, predicate);
  exec.parallel_for(name, n, HaltIf<Predicate>{predicate, exec.halt()});
  return false;
}

}  // namespace ballpit
