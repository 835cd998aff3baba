// SPDX-License-Identifier: MIT
// Span: a pointer and a length, which kernels may hold on any processor. It owns nothing.
// std::span works on the host only: its checks and constexpr functions do not compile for every device.
#pragma once

#include <cassert>
#include <cstdint>
#include <type_traits>

#include "core/host_device.h"

namespace ballpit {

template <class T>
class Span {
 public:
  HOST_DEVICE Span() = default;
  HOST_DEVICE Span(T* data, int64_t size) : data_(data), size_(size) {}

  /// A span of const T is made from a span of T.
  template <class U>
  requires std::is_same_v<const U, T> HOST_DEVICE Span(const Span<U>& other)
      : data_(other.data()), size_(other.size()) {}

  HOST_DEVICE T& operator[](int64_t i) const {
    assert(i >= 0 && i < size_);
    return data_[i];
  }
  HOST_DEVICE T* data() const { return data_; }
  HOST_DEVICE int64_t size() const { return size_; }
  HOST_DEVICE bool empty() const { return size_ == 0; }
  HOST_DEVICE T* begin() const { return data_; }
  HOST_DEVICE T* end() const { return data_ + size_; }

 private:
  T* data_ = nullptr;
  int64_t size_ = 0;
};

/// All components of vectors as one span. Kernels that treat them alike compile to vector loops.
template <class V>
HOST_DEVICE auto components(Span<V> vectors) {
  using Real = std::remove_reference_t<decltype(vectors.data()[0][0])>;
  return Span<Real>(vectors.empty() ? nullptr : &vectors.data()[0][0], vectors.size() * V::length());
}

/// One value per body; with `stride` 0 all bodies share one value, so equal radii need one number.
template <class T>
class PerBody {
 public:
  HOST_DEVICE PerBody() = default;
  HOST_DEVICE PerBody(const T* data, int stride) : data_(data), stride_(stride) {}

  /// One value for all, or one each.
  template <class U>
  PerBody(Span<U> values) : data_(values.data()), stride_(values.size() == 1 ? 0 : 1) {}

  HOST_DEVICE T operator[](int64_t i) const { return data_[i * stride_]; }
  HOST_DEVICE const T* data() const { return data_; }
  HOST_DEVICE bool is_uniform() const { return stride_ == 0; }

 private:
  const T* data_ = nullptr;
  int stride_ = 0;
};

}  // namespace ballpit
