// SPDX-License-Identifier: MIT
// Logical threads take turns as an interleaving says, and every operation is on record.
#include "lecture/record.h"

#include <functional>
#include <set>

#include <catch2/catch.hpp>

#include "core/error.h"

using namespace ballpit;
using namespace ballpit::lecture;

namespace {

/// Thread t inserts particle t into the only cell, as slides 14 and 16 do.
struct Insertion {
  RecordedMemory memory;
  int* head;
  int* next;
  bool is_atomic;

  void operator()(int t) const {
    int old;
    if (is_atomic) {
      old = memory.atomicExch(head, t);
    } else {
      old = memory.load_shared(head);
      memory.store_shared(head, t);
    }
    memory.store(next + t, old);
  }
};

struct Outcome {
  std::set<int> in_list;
  Record record;
};

Outcome insert_all(int threads, bool is_atomic, const Interleaving& interleaving) {
  std::vector<int> head{-1}, next(static_cast<size_t>(threads), -2);
  Recorder recorder;
  recorder.name("head", {head.data(), 1});
  recorder.name("next", {next.data(), threads});
  recorder.run(threads, Insertion{recorder.memory(), head.data(), next.data(), is_atomic}, interleaving);
  Outcome outcome;
  for (int i = head[0], steps = 0; i >= 0 && steps <= threads; i = next[static_cast<size_t>(i)], ++steps) {
    outcome.in_list.insert(i);
  }
  outcome.record = recorder.take();
  return outcome;
}

/// Calls visit for each order of `operations` operations by each thread.
void for_each_interleaving(int threads, int operations, const std::function<void(const Interleaving&)>& visit) {
  std::vector<int> left(static_cast<size_t>(threads), operations);
  Interleaving order;
  const std::function<void()> extend = [&] {
    if (order.size() == static_cast<size_t>(threads * operations)) return visit(order);
    for (int t = 0; t < threads; ++t) {
      if (left[static_cast<size_t>(t)] == 0) continue;
      --left[static_cast<size_t>(t)];
      order.push_back(t);
      extend();
      order.pop_back();
      ++left[static_cast<size_t>(t)];
    }
  };
  extend();
}

}  // namespace

TEST_CASE("plain loads and stores lose a particle in some interleavings of two threads, atomicExch in none") {
  int orders = 0, losses = 0;
  for_each_interleaving(2, 3, [&](const Interleaving& order) {
    ++orders;
    losses += insert_all(2, false, order).in_list.size() < 2;
  });
  CHECK(orders == 20);
  // A particle is lost unless one thread has stored `head` before the other loads it: 3 · 2 of 20 orders each keep both
  // (load and store of one come first: then the 4 operations left, of which one belongs to the first thread: 4 orders).
  CHECK(losses == 20 - 2 * 4);
  for_each_interleaving(2, 2,
                        [&](const Interleaving& order) { CHECK(insert_all(2, true, order).in_list.size() == 2); });
}

TEST_CASE("atomicExch keeps all particles in every interleaving of three threads") {
  int orders = 0;
  for_each_interleaving(3, 2, [&](const Interleaving& order) {
    ++orders;
    REQUIRE(insert_all(3, true, order).in_list == std::set<int>{0, 1, 2});
  });
  CHECK(orders == 90);
}

TEST_CASE("three threads with plain loads and stores keep between one and three particles") {
  std::set<size_t> kept;
  int orders = 0;
  for_each_interleaving(3, 3, [&](const Interleaving& order) {
    ++orders;
    kept.insert(insert_all(3, false, order).in_list.size());
  });
  CHECK(orders == 1680);
  CHECK(kept == std::set<size_t>{1, 2, 3});
}

TEST_CASE(
    "a record names thread, array, index, old and new value of each operation, in the order of the interleaving") {
  const Record record = insert_all(2, false, {0, 1, 1, 0}).record;
  struct Row {
    Action action;
    int thread, array, index, old_value, value;
  };
  const std::vector<Row> expected{{Action::load, 0, 0, 0, -1, -1},  {Action::load, 1, 0, 0, -1, -1},
                                  {Action::store, 1, 0, 0, -1, 1},  {Action::store, 0, 0, 0, 1, 0},
                                  {Action::store, 0, 1, 0, -2, -1}, {Action::store, 1, 1, 1, -2, -1}};
  REQUIRE(record.operations.size() == expected.size());
  for (size_t k = 0; k < expected.size(); ++k) {
    INFO("operation " << k);
    const Operation& found = record.operations[k];
    CHECK(found.action == expected[k].action);
    CHECK(found.thread == expected[k].thread);
    CHECK(found.array == expected[k].array);
    CHECK(found.index == expected[k].index);
    CHECK(found.old_value == expected[k].old_value);
    CHECK(found.value == expected[k].value);
  }
  CHECK(record.arrays[0].name == "head");
  CHECK(record.values_after(0, 0) == std::vector<int>{-1});
  CHECK(record.values_after(0, 3) == std::vector<int>{1});
  CHECK(record.values_after(0, 6) == std::vector<int>{0});
  CHECK(record.values_after(1, 5) == std::vector<int>{-1, -2});
}

TEST_CASE("an operation has the line of the kernel that performs it") {
  const Record record = insert_all(1, true, {}).record;
  REQUIRE(record.operations.size() == 2);
  CHECK(record.operations[1].line - record.operations[0].line == 5);  // in Insertion above
}

TEST_CASE("an interleaving that names a thread that does not exist is refused") {
  CHECK_THROWS_WITH(insert_all(2, true, {0, 2}), Catch::Contains("thread 2") && Catch::Contains("0 to 1"));
}

TEST_CASE("a finished thread is passed over, and threads that an interleaving leaves out finish in order") {
  const Outcome outcome = insert_all(3, true, {2, 2, 2, 2, 0});
  CHECK(outcome.in_list.size() == 3);
  std::vector<int> threads;
  for (const Operation& operation : outcome.record.operations) threads.push_back(operation.thread);
  CHECK(threads == std::vector<int>{2, 2, 0, 0, 1, 1});
}
