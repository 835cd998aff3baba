// SPDX-License-Identifier: MIT
#include "lecture/record.h"

#include <limits>
#include <stdexcept>

#include "core/error.h"

namespace ballpit::lecture {

std::vector<int> Record::values_after(int array, size_t count) const {
  std::vector<int> values = arrays.at(static_cast<size_t>(array)).values;
  for (size_t k = 0; k < count && k < operations.size(); ++k) {
    const Operation& operation = operations[k];
    if (operation.array != array || operation.action == Action::load) continue;
    values.at(static_cast<size_t>(operation.index)) = operation.value;
  }
  return values;
}

int RecordedMemory::value(int computed, int line) const {
  return recorder_->perform({.action = Action::compute, .thread = 0, .line = line, .value = computed}, nullptr);
}

int RecordedMemory::load(const int* at, int line) const {
  return recorder_->perform({.action = Action::load, .thread = 0, .line = line}, at);
}

void RecordedMemory::store(int* at, int stored, int line) const {
  recorder_->perform({.action = Action::store, .thread = 0, .line = line, .value = stored}, at);
}

int RecordedMemory::atomicExch(int* at, int stored, int line) const {
  return recorder_->perform({.action = Action::exchange, .thread = 0, .line = line, .value = stored}, at);
}

bool RecordedMemory::test(int i, int j, bool is_contact, int line) const {
  return recorder_->perform(
      {.action = Action::test, .thread = 0, .line = line, .index = i, .value = is_contact, .other = j}, nullptr);
}

void Recorder::name(std::string name, Span<int> memory) {
  record_.arrays.push_back({std::move(name), {memory.begin(), memory.end()}});
  memory_.push_back(memory);
}

int Recorder::perform(Operation operation, const int* at) {
  if (repeated_ < current_->results.size()) return current_->results[repeated_++];
  if (is_shared(operation.action)) {
    if (allowed_ == 0) throw Paused{};
    --allowed_;
  }
  operation.thread = number_;
  int result = operation.value;
  if (at) {
    size_t array = 0;
    while (array < memory_.size() && (at < memory_[array].begin() || at >= memory_[array].end())) ++array;
    if (array == memory_.size()) throw std::logic_error("memory without a name");
    operation.array = static_cast<int>(array);
    operation.index = at - memory_[array].begin();
    int& element = memory_[array][operation.index];
    operation.old_value = result = element;
    if (operation.action == Action::load) {
      operation.value = element;
    } else {
      element = operation.value;
    }
  }
  record_.operations.push_back(operation);
  current_->results.push_back(result);
  ++repeated_;
  return result;
}

void Recorder::advance(Thread& thread, int number, RunThread body, const void* kernel, int64_t allowed) {
  current_ = &thread;
  number_ = number;
  repeated_ = 0;
  allowed_ = allowed;
  try {
    body(kernel, number);
    thread.is_finished = true;
  } catch (const Paused&) {
  }
}

void Recorder::run_threads(int threads, RunThread body, const void* kernel, const Interleaving& interleaving) {
  std::vector<Thread> states(static_cast<size_t>(threads));
  for (const int number : interleaving) {
    if (number < 0 || number >= threads) {
      throw UserError("interleaving", "thread " + std::to_string(number),
                      "threads 0 to " + std::to_string(threads - 1));
    }
    Thread& thread = states[static_cast<size_t>(number)];
    if (!thread.is_finished) advance(thread, number, body, kernel, 1);
  }
  for (int number = 0; number < threads; ++number) {
    Thread& thread = states[static_cast<size_t>(number)];
    if (!thread.is_finished) advance(thread, number, body, kernel, std::numeric_limits<int64_t>::max());
  }
}

}  // namespace ballpit::lecture
