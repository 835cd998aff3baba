// SPDX-License-Identifier: MIT
// What is compiled once for each vector type and executor: detection, and what stands between it and the responses.
//
//     BALLPIT_DETECTION(, Vec3, CpuExecutor)          compiles it here: detection_cpu_*.cpp
//     BALLPIT_DETECTION(extern, Vec3, CpuExecutor)    says that it is compiled elsewhere
//
// Without the second, each response's file would compile all broad phases and their kernels again.
#pragma once

#include "narrow_phase/collider.h"
#include "world/body_store.h"
#include "world/tally_on.h"

#define BALLPIT_DETECTION(EXTERN, V, Exec)             \
  EXTERN template class ballpit::Collider<V, Exec>;    \
  EXTERN template class ballpit::ContactList<V, Exec>; \
  EXTERN template class ballpit::BodyStore<V, Exec>;   \
  EXTERN template class ballpit::TallyKeeper<V, Exec>
