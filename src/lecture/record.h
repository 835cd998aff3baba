// SPDX-License-Identifier: MIT
// Records what the slides' kernels do, operation by operation. The threads of a kernel are logical threads: they run in
// this one thread and pass a baton at each operation on shared memory, in any interleaving.
//
//     interleaving 0 1 1 0          thread 0   load head[4] → −1               store head[4] ← 3
//                                   thread 1                    load → −1, store ← 5            (sphere 5 is lost)
//
// A thread that must wait is left by an exception. When its turn comes again, its kernel runs from the start; the
// operations that it has done already return their results of then. So a kernel needs no means to pause, and its local
// variables are as they were. Cost: a thread that waits k times repeats its operations k times.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/span.h"
#include "lecture/kernels/memory.h"

namespace ballpit::lecture {

enum class Action {
  compute,   ///< the thread computed `value`
  load,      ///< read `value` from array[index]
  store,     ///< array[index]: `old_value` became `value`
  exchange,  ///< the same, and the thread got old_value
  test,      ///< spheres `index` and `other`; value is 1 if they touch
};

/// Whether other threads may notice the operation: only before these is the baton passed.
constexpr bool is_shared(Action action) { return action != Action::compute && action != Action::test; }

struct Operation {
  Action action;
  int thread;
  int line;        ///< of the kernel's source file
  int array = -1;  ///< in Record::arrays
  int64_t index = 0;
  int old_value = 0;
  int value = 0;
  int other = -1;
};

/// Memory that no kernel has written yet.
inline constexpr int kUnset = std::numeric_limits<int>::min();

/// An array that kernels work on, as it was when it was named.
struct RecordedArray {
  std::string name;
  std::vector<int> values;
};

struct Record {
  std::vector<RecordedArray> arrays;
  std::vector<Operation> operations;

  /// An array after the first `count` operations.
  std::vector<int> values_after(int array, size_t count) const;
};

/// Which thread performs the next shared operation. When all are used up, the threads finish one after the other.
using Interleaving = std::vector<int>;

class Recorder;

/// The memory policy of one logical thread.
class RecordedMemory {
 public:
  RecordedMemory() = default;
  explicit RecordedMemory(Recorder& recorder) : recorder_(&recorder) {}

  int value(int computed, int line = __builtin_LINE()) const;
  int load(const int* at, int line = __builtin_LINE()) const;
  void store(int* at, int stored, int line = __builtin_LINE()) const;
  int load_shared(const int* at, int line = __builtin_LINE()) const { return load(at, line); }
  void store_shared(int* at, int stored, int line = __builtin_LINE()) const { store(at, stored, line); }
  int atomicExch(int* at, int stored, int line = __builtin_LINE()) const;
  bool test(int i, int j, bool is_contact, int line = __builtin_LINE()) const;
  void append(const PairSink&, int, int) const {}  // a test that found a contact says so

 private:
  Recorder* recorder_ = nullptr;
};

class Recorder {
 public:
  /// Operations on `memory` are recorded under this name. It must outlive the recorder.
  void name(std::string name, Span<int> memory);

  RecordedMemory memory() { return RecordedMemory(*this); }

  /// Runs kernel(t) for each t in 0 … threads−1. Throws UserError if the interleaving names another thread.
  template <class Kernel>
  void run(int threads, const Kernel& kernel, const Interleaving& interleaving = {}) {
    run_threads(
        threads, [](const void* k, int t) { (*static_cast<const Kernel*>(k))(t); }, &kernel, interleaving);
  }

  const Record& record() const { return record_; }
  Record take() { return std::move(record_); }

 private:
  friend class RecordedMemory;
  struct Paused {};
  struct Thread {
    std::vector<int> results;  // of the operations done
    bool is_finished = false;
  };
  using RunThread = void (*)(const void* kernel, int thread);

  void run_threads(int threads, RunThread body, const void* kernel, const Interleaving& interleaving);
  void advance(Thread& thread, int number, RunThread body, const void* kernel, int64_t allowed);

  /// Performs an operation, or repeats its result. `at` is null unless it is on memory.
  int perform(Operation operation, const int* at);

  Record record_;
  std::vector<Span<int>> memory_;  // of the record's arrays
  Thread* current_ = nullptr;
  int number_ = 0;
  size_t repeated_ = 0;  // results of the current thread that were given again
  int64_t allowed_ = 0;  // shared operations until it must wait
};

}  // namespace ballpit::lecture
