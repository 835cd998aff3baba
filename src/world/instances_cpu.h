// SPDX-License-Identifier: MIT
// Classes that are compiled once for each vector type: detection and bodies.
//
//     BALLPIT_DETECTION(, ballpit::Vec3)          compiled here: detection_cpu_*.cpp
//     BALLPIT_DETECTION(extern, ballpit::Vec3)    compiled elsewhere
//
// Without the second form, the file of each response would compile all broad phases again.
#pragma once

#include "exec/cpu_executor.h"
#include "narrow_phase/collider.h"
#include "world/body_store.h"
#include "world/tally_on.h"

#define BALLPIT_DETECTION(EXTERN, V)                                   \
  EXTERN template class ballpit::Collider<V, ballpit::CpuExecutor>;    \
  EXTERN template class ballpit::ContactList<V, ballpit::CpuExecutor>; \
  EXTERN template class ballpit::BodyStore<V, ballpit::CpuExecutor>;   \
  EXTERN template class ballpit::TallyKeeper<V, ballpit::CpuExecutor>

BALLPIT_DETECTION(extern, ballpit::Vec2);
BALLPIT_DETECTION(extern, ballpit::Vec3);
BALLPIT_DETECTION(extern, ballpit::Vec2d);
BALLPIT_DETECTION(extern, ballpit::Vec3d);
