// SPDX-License-Identifier: MIT
// Pairs that the CPU finds in blocks of work. Each block has a buffer of its own; they are joined in the order of the
// blocks.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "exec/cpu_executor.h"
#include "narrow_phase/contact_rows.h"

namespace ballpit {

/// A buffer of pairs whose memory only grows.
class PairBuffer {
 public:
  /// Makes room for `more` additional pairs.
  void reserve(int64_t more) {
    if (count_ + more > capacity_) grow(std::max(count_ + more, 2 * capacity_));
  }
  Pair* end() { return data_.get() + count_; }
  void set_end(const Pair* end) { count_ = end - data_.get(); }
  void clear() { count_ = 0; }
  int64_t size() const { return count_; }
  Span<const Pair> span() const { return {data_.get(), count_}; }
  int64_t bytes() const { return capacity_ * int64_t(sizeof(Pair)); }

 private:
  [[gnu::noinline]] void grow(int64_t capacity) {
    auto data = std::make_unique_for_overwrite<Pair[]>(static_cast<size_t>(capacity));
    std::copy(data_.get(), data_.get() + count_, data.get());
    data_ = std::move(data);
    capacity_ = capacity;
  }

  std::unique_ptr<Pair[]> data_;
  int64_t count_ = 0;
  int64_t capacity_ = 0;
};

/// The buffers of all blocks. A single thread takes the blocks in order and needs only one buffer.
class PairBlocks {
 public:
  /// With room for `each` pairs of a block. Memory that is never written costs no time; copying into more memory does.
  void start(const CpuExecutor& exec, int64_t blocks, int64_t each) {
    buffers_.resize(static_cast<size_t>(exec.threads() == 1 ? 1 : blocks));
    for (PairBuffer& buffer : buffers_) {
      buffer.clear();
      buffer.reserve(exec.threads() == 1 ? blocks * each : each);
    }
  }

  PairBuffer& of(int64_t block) { return buffers_[buffers_.size() == 1 ? 0 : static_cast<size_t>(block)]; }

  /// All pairs, in the order of the blocks.
  Span<const Pair> join(CpuExecutor& exec) {
    const int64_t count = find_starts();
    if (buffers_.size() == 1) return buffers_[0].span();
    joined_.resize(count);
    copy(exec, joined_.span());
    return joined_.span();
  }

  /// The same, to the pairs of `rows`.
  void join(CpuExecutor& exec, int64_t bodies, ContactRows<CpuExecutor>& rows) {
    rows.resize(bodies, find_starts());
    copy(exec, rows.pairs());
  }

  int64_t bytes() const {
    int64_t sum = joined_.bytes();
    for (const PairBuffer& buffer : buffers_) sum += buffer.bytes();
    return sum;
  }

 private:
  /// Returns the number of pairs.
  int64_t find_starts() {
    starts_.assign(buffers_.size() + 1, 0);
    for (size_t b = 0; b < buffers_.size(); ++b) starts_[b + 1] = starts_[b] + buffers_[b].size();
    return checked_count(starts_.back(), "contacts");
  }

  void copy(CpuExecutor& exec, Span<Pair> to) const {
    exec.parallel_for_blocks("join contacts", static_cast<int64_t>(buffers_.size()), [&](int64_t b) {
      const Span<const Pair> pairs = buffers_[static_cast<size_t>(b)].span();
      std::copy(pairs.begin(), pairs.end(), to.data() + starts_[static_cast<size_t>(b)]);
    });
  }

  std::vector<PairBuffer> buffers_;
  std::vector<int64_t> starts_;  // of each buffer's pairs among all
  HostBuffer<Pair> joined_;
};

}  // namespace ballpit
