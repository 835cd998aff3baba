// SPDX-License-Identifier: MIT
// What lets a host go on without waiting for a device that computes (cuda/cuda_executor.h). While an executor defers,
//
//     counts        are not read: a Bounded has room for so many elements, and a pointer to how many there are
//     conditions    that end a run are not read either: stops_if() lets the device halt
//     halted        kernels do nothing any more, so nothing is exceeded; the host finds out later, goes back to the
//                   last good state and repeats the steps from there without deferring
//
// On the CPU nothing is deferred: counts are exact, and conditions are known at once.
#pragma once

#include "core/bounded.h"
#include "core/host_device.h"
#include "core/span.h"
#include "exec/atomics.h"

namespace ballpit {

/// Where kernels halt the device; nowhere on the CPU.
struct Halt {
  int* device = nullptr;
  int* host = nullptr;  ///< the same for the host

  HOST_DEVICE void raise() const {
    if (device == nullptr) return;
    atomic_exchange(device, 1);
    relaxed_store(host, 1);
  }
};

/// Kernel: halts if predicate(i).
template <class Predicate>
struct HaltIf {
  Predicate predicate;
  Halt halt;

  HOST_DEVICE void operator()(int i) const {
    if (predicate(i)) halt.raise();
  }
};

}  // namespace ballpit
