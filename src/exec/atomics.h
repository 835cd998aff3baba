// SPDX-License-Identifier: MIT
// Atomic operations on integers in buffers (slide 17), for kernels on both processors.
// Relaxed order suffices: a launch ends before its results are read.
#pragma once

#include <atomic>

#include "core/host_device.h"

namespace ballpit {

/// Stores `value` at `*at` and returns the old value, as one indivisible operation.
HOST_DEVICE inline int atomic_exchange(int* at, int value) {
#ifdef __CUDA_ARCH__
  return atomicExch(at, value);
#else
  return std::atomic_ref<int>(*at).exchange(value, std::memory_order_relaxed);
#endif
}

/// Adds `value` to `*at` and returns the old value, as one indivisible operation.
HOST_DEVICE inline unsigned long long atomic_add(unsigned long long* at, unsigned long long value) {
#ifdef __CUDA_ARCH__
  return atomicAdd(at, value);
#else
  return std::atomic_ref<unsigned long long>(*at).fetch_add(value, std::memory_order_relaxed);
#endif
}

HOST_DEVICE inline int atomic_add(int* at, int value) {
#ifdef __CUDA_ARCH__
  return atomicAdd(at, value);
#else
  return std::atomic_ref<int>(*at).fetch_add(value, std::memory_order_relaxed);
#endif
}

/// Reads memory that other threads write at the same time.
HOST_DEVICE inline int relaxed_load(const int* at) {
#ifdef __CUDA_ARCH__
  return *static_cast<const volatile int*>(at);
#else
  return std::atomic_ref<int>(*const_cast<int*>(at)).load(std::memory_order_relaxed);
#endif
}

/// Writes memory that other threads read or write at the same time.
HOST_DEVICE inline void relaxed_store(int* at, int value) {
#ifdef __CUDA_ARCH__
  *static_cast<volatile int*>(at) = value;
#else
  std::atomic_ref<int>(*at).store(value, std::memory_order_relaxed);
#endif
}

}  // namespace ballpit
