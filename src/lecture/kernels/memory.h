// SPDX-License-Identifier: MIT
// The memory operations of the slides' kernels. Each kernel is a template over one of these policies:
//
//     PlainMemory       one thread after the other
//     AtomicMemory      many threads at once, on the CPU or the GPU
//     RecordedMemory    logical threads in any interleaving, each operation is kept (record.h)
//
// atomicExch and atomicAdd have the names of slide 17.
#pragma once

#include "bodies/pair.h"
#include "core/host_device.h"
#include "core/span.h"
#include "exec/atomics.h"

namespace ballpit::lecture {

/// Where kernels append the pairs in contact. If there are more than fit, only their count is right.
struct PairSink {
  Span<Pair> pairs;
  unsigned long long* count = nullptr;

  HOST_DEVICE void put(unsigned long long at, int i, int j) const {
    if (at < static_cast<unsigned long long>(pairs.size())) {
      pairs[static_cast<int64_t>(at)] = i < j ? Pair{i, j} : Pair{j, i};
    }
  }
};

/// What a thread has done.
struct Work {
  int tests = 0;  ///< pairs of spheres
  int steps = 0;  ///< entries of lists that it has read

  HOST_DEVICE void count_test() { ++tests; }
  HOST_DEVICE void count_step() { ++steps; }
};

struct PlainMemory {
  /// A value that a thread computes, for the record.
  HOST_DEVICE int value(int computed) const { return computed; }

  HOST_DEVICE int load(const int* at) const { return *at; }
  HOST_DEVICE void store(int* at, int stored) const { *at = stored; }

  /// Access to memory that other threads use at the same time. Not atomic as a pair: slide 16.
  HOST_DEVICE int load_shared(const int* at) const { return *at; }
  HOST_DEVICE void store_shared(int* at, int stored) const {
    *at = stored;
  }

  /// Stores a value and returns the old one.
  HOST_DEVICE int atomicExch(int* at, int stored) const {
    const int old = *at;
    *at = stored;
    return old;
  }

  /// The outcome of a test of two spheres, for the record.
  HOST_DEVICE bool test(int, int, bool is_contact) const {
    return is_contact;
  }

  HOST_DEVICE void append(const PairSink& sink, int i, int j) const {
    sink.put((*sink.count)++, i, j);
  }
};

struct AtomicMemory : PlainMemory {
  HOST_DEVICE int load_shared(const int* at) const {
    return relaxed_load(at);
  }
  HOST_DEVICE void store_shared(int* at, int stored) const {
    relaxed_store(at, stored);
  }
  HOST_DEVICE int atomicExch(int* at, int stored) const {
    return atomic_exchange(at, stored);
  }
  HOST_DEVICE void append(const PairSink& sink, int i, int j) const {
    sink.put(atomic_add(sink.count, 1), i, j);
  }
};

}  // namespace ballpit::lecture
