// SPDX-License-Identifier: MIT
// HostBuffer: an owned array of plain values in main memory. Resizing may drop the contents. The capacity grows by
// half, so that a slowly growing count does not allocate in every step. A vector register of kReach bytes may be read or
// written at any value, as far as memory goes: the bytes after the last value belong to nobody. Its sibling on the GPU
// is DeviceBuffer in cuda/.
#pragma once

#include <algorithm>
#include <memory>
#include <type_traits>

#include "core/span.h"

namespace ballpit {

template <class T>
class HostBuffer {
  static_assert(std::is_trivially_copyable_v<T>, "buffers hold plain values");

 public:
  HostBuffer() = default;

  /// Makes room for n values; the contents are undefined afterwards. Throws std::bad_alloc.
  void resize(int64_t n) {
    if (n > capacity_) {
      const int64_t capacity = std::max(n, capacity_ + capacity_ / 2);
      data_.reset();  // frees first: both together might not fit into memory
      data_ = std::make_unique_for_overwrite<T[]>(static_cast<size_t>(capacity) + kSpare);
      capacity_ = capacity;
    }
    size_ = n;
  }

  int64_t size() const { return size_; }
  int64_t bytes() const { return capacity_ * int64_t(sizeof(T)); }  ///< of memory held
  Span<T> span() { return {data_.get(), size_}; }
  Span<const T> span() const { return {data_.get(), size_}; }

  static constexpr size_t kReach = 16;

 private:
  static constexpr size_t kSpare = (kReach - 1) / sizeof(T);  // values after the last

  std::unique_ptr<T[]> data_;
  int64_t size_ = 0;
  int64_t capacity_ = 0;
};

}  // namespace ballpit
