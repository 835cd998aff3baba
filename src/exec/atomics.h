// SPDX-License-Identifier: MIT
// The atomic exchange of integers in buffers (slide 17), for kernels on both processors.
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

}  // namespace ballpit
