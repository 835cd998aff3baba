// SPDX-License-Identifier: MIT
// Classes that are compiled once for each vector type and executor: detection and bodies.
//
//     BALLPIT_DETECTION(, Vec3, CpuExecutor)          compiled here: detection_cpu_*.cpp
//     BALLPIT_DETECTION(extern, Vec3, CpuExecutor)    compiled elsewhere
//
// Without the second form, the file of each response would compile all broad phases again.
#pragma once

#include "narrow_phase/collider.h"
#include "world/body_store.h"
#include "world/tally_on.h"

#define BALLPIT_DETECTION(EXTERN, V, Exec)             \
  EXTERN template class ballpit::Collider<V, Exec>;    \
  EXTERN template class ballpit::ContactList<V, Exec>; \
  EXTERN template class ballpit::BodyStore<V, Exec>;   \
  EXTERN template class ballpit::TallyKeeper<V, Exec>
