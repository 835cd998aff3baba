// SPDX-License-Identifier: MIT
// Atomic operations on plain integers in buffers (slide 17), for kernels that run on either processor.
// Relaxed order suffices: a launch ends before anything that it wrote is read.
#pragma once

#include <atomic>

#include "core/host_device.h"

namespace ballpit {

/// Stores `value` at `*at` and returns what was there, as one indivisible operation.
HOST_DEVICE inline int atomic_exchange(int* at, int value) {
#ifdef __CUDA_ARCH__
  return atomicExch(at, value);
#else
  return std::atomic_ref<int>(*at).exchange(value, std::memory_order_relaxed);
#endif
}

/// Adds `value` to `*at` and returns what was there, as one indivisible operation.
HOST_DEVICE inline int atomic_add(int* at, int value) {
#ifdef __CUDA_ARCH__
  return atomicAdd(at, value);
#else
  return std::atomic_ref<int>(*at).fetch_add(value, std::memory_order_relaxed);
#endif
}

}  // namespace ballpit
