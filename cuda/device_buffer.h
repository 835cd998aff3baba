// SPDX-License-Identifier: MIT
// DeviceBuffer: an owned array of plain values in the GPU's memory; the sibling of HostBuffer, with the same interface.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/span.h"
#include "cuda_error.h"

namespace ballpit {

/// While this thread has launches that wait to be submitted, memory that they use is kept here (cuda_queue.h).
inline thread_local std::vector<void*>* memory_in_use = nullptr;

template <class T>
class DeviceBuffer {
  static_assert(std::is_trivially_copyable_v<T>, "buffers hold plain values");

 public:
  DeviceBuffer() = default;
  ~DeviceBuffer() { release(); }
  DeviceBuffer(DeviceBuffer&& other) noexcept { swap(other); }
  DeviceBuffer& operator=(DeviceBuffer&& other) noexcept {
    swap(other);
    return *this;
  }

  /// Makes room for n values; the contents are undefined afterwards. Throws RunError if the device is out of memory.
  void resize(int64_t n) {
    if (n > capacity_) {
      const int64_t capacity = std::max(n, capacity_ + capacity_ / 2);
      release();
      BALLPIT_CUDA_CHECK(cudaMalloc(&data_, static_cast<size_t>(capacity) * sizeof(T)));
      capacity_ = capacity;
    }
    size_ = n;
  }

  int64_t size() const { return size_; }
  int64_t capacity() const { return capacity_; }
  int64_t bytes() const { return capacity_ * int64_t(sizeof(T)); }  ///< of memory held
  Span<T> span() { return {data_, size_}; }
  Span<const T> span() const { return {data_, size_}; }

 private:
  void swap(DeviceBuffer& other) {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  /// If freeing fails, an earlier launch has failed, and its own check reports it.
  void release() {
    void* const memory = std::exchange(data_, nullptr);
    size_ = capacity_ = 0;
    if (memory == nullptr) return;
    if (memory_in_use != nullptr) {
      memory_in_use->push_back(memory);
    } else {
      (void)cudaFree(memory);
    }
  }

  T* data_ = nullptr;
  int64_t size_ = 0;
  int64_t capacity_ = 0;
};

}  // namespace ballpit
