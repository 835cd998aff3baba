// SPDX-License-Identifier: MIT
// A device that is none: an executor that runs what CudaExecutor runs, one index after the other, defers as it does, and
// keeps account of each launch: its kernels, and the bytes of the arrays that it touches.
//
// Each array lies in pages of its own. They are closed before a launch; the first access to a page opens and counts it. So
// the account has what a kernel reads or writes, each array once, and not what it could. Not for several threads at once.
#pragma once

#include <csignal>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <sys/mman.h>

#include "cuda/bin_kernels.h"
#include "exec/deferred.h"
#include "exec/phases.h"
#include "exec/stage_times.h"

namespace ballpit::ledger {

inline constexpr int64_t kPage = 4096;  // [byte]

/// All arrays: their bytes by where they begin.
inline std::map<char*, int64_t>& arrays() {
  static std::map<char*, int64_t> all;
  return all;
}

inline int64_t& pages_touched() {
  static int64_t pages = 0;
  return pages;
}

inline void protect_all(int protection) {
  for (const auto& [begin, room] : arrays()) mprotect(begin, size_t(room), protection);
}

/// Opens the page that was accessed. What is in no array is a fault as ever.
inline void note_access(int signal, siginfo_t* info, void*) {
  const auto at = static_cast<char*>(info->si_addr);
  auto found = arrays().upper_bound(at);
  if (found != arrays().begin() && at < (--found)->first + found->second) {
    ++pages_touched();
    mprotect(at - reinterpret_cast<uintptr_t>(at) % kPage, kPage, PROT_READ | PROT_WRITE);
  } else {
    std::signal(signal, SIG_DFL);
  }
}

template <class T>
class Buffer {
 public:
  Buffer() = default;
  ~Buffer() { release(); }
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }

  void resize(int64_t n) {
    if (n > capacity_) {
      const int64_t capacity = std::max(n, capacity_ + capacity_ / 2);
      release();
      const int64_t room = (capacity * int64_t(sizeof(T)) + kPage - 1) / kPage * kPage;
      void* const memory = mmap(nullptr, size_t(room), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      if (memory == MAP_FAILED) throw std::bad_alloc();
      std::memset(memory, 0xCD, size_t(room));
      data_ = static_cast<T*>(memory);
      capacity_ = capacity;
      arrays()[static_cast<char*>(memory)] = room;
    }
    size_ = n;
  }

  int64_t size() const { return size_; }
  int64_t capacity() const { return capacity_; }
  int64_t bytes() const { return capacity_ * int64_t(sizeof(T)); }
  Span<T> span() { return {data_, size_}; }
  Span<const T> span() const { return {data_, size_}; }

 private:
  char* begin() const { return reinterpret_cast<char*>(data_); }

  void swap(Buffer& other) {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  void release() {
    if (data_ == nullptr) return;
    munmap(begin(), size_t(arrays()[begin()]));
    arrays().erase(begin());
    data_ = nullptr;
    size_ = capacity_ = 0;
  }

  T* data_ = nullptr;
  int64_t size_ = 0, capacity_ = 0;
};

struct Launch {
  std::string name;
  int kernels;
  int64_t bytes;
};

class Executor {
 public:
  template <class T>
  using Buffer = ledger::Buffer<T>;
  static constexpr bool kDefers = true;
  static constexpr bool runs_in_order() { return false; }

  Executor() {
    struct sigaction action {};
    action.sa_sigaction = note_access;
    action.sa_flags = SA_SIGINFO | SA_NODEFER;
    sigaction(SIGSEGV, &action, &before_);
  }
  ~Executor() { sigaction(SIGSEGV, &before_, nullptr); }

  std::vector<Launch> launches;
  int64_t waits = 0, halts = 0;

  StageTimes& stage_times() { return times_; }
  void time_stages(bool) {}

  template <class Work>
  void defer(const Work& work) {
    is_deferring_ = true;
    work();
    is_deferring_ = false;
  }
  bool is_deferring() const { return is_deferring_; }
  Halt halt() { return is_deferring_ ? Halt{&halted_[0], &halted_[1]} : Halt{}; }
  void raise_halt() { halted_[0] = halted_[1] = 1; }
  bool seems_halted() const { return halted_[1] != 0; }
  bool has_halted() { return seems_halted(); }
  void go_on() {
    halted_[0] = halted_[1] = 0;
    ++halts;
  }

  template <class Kernel>
  void parallel_for(const char* name, int64_t n, const Kernel& kernel) {
    parallel_for(name, Bounded{n, nullptr}, kernel);
  }
  template <class Kernel>
  void parallel_for(const char* name, const Bounded& n, const Kernel& kernel) {
    if (n.most == 0 || has_stopped()) return;
    // A device reads the count as well, but that is no array of its own.
    const int64_t count = n.count != nullptr ? std::min<int64_t>(n.most, *n.count) : n.most;
    note(name, 1, [&] {
      for (int64_t i = 0; i < count && !has_stopped(); ++i) kernel(static_cast<int>(i));
    });
  }
  template <Phases P>
  void run_phases(const char* name, int64_t most, P phases) {
    if (most == 0 || has_stopped()) return;
    note(name, 1, [&] {
      while (phases.next()) {
        CHECK(phases.size() <= most);
        for (int i = 0; i < phases.size(); ++i) phases(i);
      }
    });
  }
  template <class T>
  void fill(const char* name, Span<T> span, T value) {
    if (!span.empty() && !has_stopped()) note(name, 1, [&] { std::fill(span.begin(), span.end(), value); });
  }
  void clear(Span<int> span) {
    if (!span.empty()) note("clear", 0, [&] { std::fill(span.begin(), span.end(), 0); });
  }

  /// Two kernels, as CUB has them.
  int64_t exclusive_scan(const char* name, Span<const int> counts, Span<int> offsets) {
    int64_t sum = 0;
    note(name, 2, [&] { sum = scan(counts, offsets); });
    waits += !is_deferring_;
    return sum;
  }
  int64_t exclusive_scan(const char* name, Span<const int> a, Span<const int> b, Span<int> a_offsets,
                         Span<int> b_offsets) {
    int64_t sum = 0;
    note(name, 2, [&] {
      scan(a, a_offsets);
      sum = scan(b, b_offsets);
    });
    waits += !is_deferring_;
    return sum;
  }

  template <class KeyOf>
  void bin_few(const char* name, const KeyOf& key_of, Span<int> offsets, Span<int> order) {
    const int64_t n = order.size(), bins = offsets.size() - 1;
    keys_.resize(n);
    unsorted_.resize(n);
    counts_.resize(bins);
    clear(counts_.span());
    parallel_for(name, n, CountKey<KeyOf>{key_of, keys_.span(), counts_.span()});
    note(name, 2, [&] { scan(counts_.span(), offsets); });
    parallel_for(name, n, PlaceIndex{keys_.span(), offsets, counts_.span(), unsorted_.span()});
    parallel_for(name, n, RankIndex{keys_.span(), offsets, unsorted_.span(), order});
  }

  /// Stable; of a device's radix sort only the result.
  template <class KeyOf, class ValueOf, class T>
  void bin(const char*, const KeyOf& key_of, const ValueOf& value_of, Span<int> offsets, Span<T> values) {
    std::fill(offsets.begin(), offsets.end(), 0);
    std::vector<int> keys;
    for (int64_t i = 0; i < values.size(); ++i) ++offsets[1 + keys.emplace_back(key_of(int(i)))];
    for (int64_t k = 1; k < offsets.size(); ++k) offsets[k] += offsets[k - 1];
    std::vector<int> next(offsets.begin(), offsets.end());
    for (int64_t i = 0; i < values.size(); ++i) values[next[size_t(keys[size_t(i)])]++] = value_of(int(i));
  }
  template <class KeyOf>
  void bin(const char* name, const KeyOf& key_of, Span<int> offsets, Span<int> order) {
    bin(
        name, key_of, [](int i) { return i; }, offsets, order);
  }
  template <class Key, class Value>
  void sort_pairs(const char*, Span<Key> keys, Span<Value> values, int bits = int(sizeof(Key) * 8)) {
    const Key mask = bits == int(sizeof(Key) * 8) ? ~Key(0) : Key((Key(1) << bits) - 1);
    std::vector<std::pair<Key, Value>> pairs;
    for (int64_t i = 0; i < keys.size(); ++i) pairs.emplace_back(keys[i], values[i]);
    std::stable_sort(pairs.begin(), pairs.end(),
                     [&](const auto& a, const auto& b) { return (a.first & mask) < (b.first & mask); });
    for (size_t i = 0; i < pairs.size(); ++i) std::tie(keys[int64_t(i)], values[int64_t(i)]) = pairs[i];
  }

  template <class T>
  Span<T> scratch(int index, int64_t n) {
    scratch_[index].resize(n * int64_t(sizeof(T)));
    return {reinterpret_cast<T*>(scratch_[index].span().data()), n};
  }
  template <class T>
  void upload(Buffer<T>& buffer, const T* values, int64_t n) {
    buffer.resize(n);
    std::copy(values, values + n, buffer.span().data());
  }
  template <class T>
  void upload(Buffer<T>& buffer, const std::vector<T>& values) {
    upload(buffer, values.data(), int64_t(values.size()));
  }
  template <class T>
  std::vector<std::remove_const_t<T>> download(Span<T> span) {
    ++waits;
    return {span.begin(), span.end()};
  }

 private:
  bool has_stopped() const { return is_deferring_ && halted_[0] != 0; }

  static int64_t scan(Span<const int> counts, Span<int> offsets) {
    int64_t sum = 0;
    for (int64_t i = 0; i < counts.size(); ++i) {
      offsets[i] = int(sum);
      sum += counts[i];
    }
    offsets[counts.size()] = int(sum);
    return sum;
  }

  /// Does the work of a launch, and notes what it touches.
  template <class Work>
  void note(const char* name, int kernels, const Work& work) {
    protect_all(PROT_NONE);
    pages_touched() = 0;
    work();
    launches.push_back({name, kernels, pages_touched() * kPage});
    protect_all(PROT_READ | PROT_WRITE);
  }

  struct sigaction before_ {};
  StageTimes times_;
  bool is_deferring_ = false;
  int halted_[2] = {0, 0};
  Buffer<int> keys_, unsorted_, counts_;
  Buffer<char> scratch_[2];
};

}  // namespace ballpit::ledger
