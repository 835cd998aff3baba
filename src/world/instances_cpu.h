// SPDX-License-Identifier: MIT
// What is compiled once for each vector type: detection, bodies and inspection.
//
//     BALLPIT_DETECTION(, ballpit::Vec3)          compiled here: detection_cpu_*.cpp
//     BALLPIT_DETECTION(extern, ballpit::Vec3)    compiled elsewhere
//     BALLPIT_INSPECTION                          the same for what only the audience sees: inspection_cpu.cpp
//
// Without the second form, the file of each response would compile all broad phases again.
#pragma once

#include "exec/cpu_executor.h"
#include "narrow_phase/collider.h"
#include "world/body_store.h"
#include "world/inspect_more.h"
#include "world/occluders.h"
#include "world/tally_on.h"

#define BALLPIT_DETECTION(EXTERN, V)                                   \
  EXTERN template class ballpit::Collider<V, ballpit::CpuExecutor>;    \
  EXTERN template class ballpit::ContactList<V, ballpit::CpuExecutor>; \
  EXTERN template class ballpit::BodyStore<V, ballpit::CpuExecutor>;   \
  EXTERN template class ballpit::TallyKeeper<V, ballpit::CpuExecutor>

#define BALLPIT_INSPECTION(EXTERN, V)                                                            \
  EXTERN template void ballpit::inspect_more(const ballpit::BodyStore<V, ballpit::CpuExecutor>&, \
                                             const ballpit::Collider<V, ballpit::CpuExecutor>&,  \
                                             const ballpit::Wanted&, ballpit::Inspection&);      \
  EXTERN template std::pair<std::vector<int>, std::vector<int>> ballpit::thread_work(            \
      ballpit::CpuExecutor&, const ballpit::Collider<V, ballpit::CpuExecutor>&);                 \
  EXTERN template class ballpit::OccluderSearch<V, ballpit::CpuExecutor>

BALLPIT_DETECTION(extern, ballpit::Vec2);
BALLPIT_DETECTION(extern, ballpit::Vec3);
BALLPIT_DETECTION(extern, ballpit::Vec2d);
BALLPIT_DETECTION(extern, ballpit::Vec3d);

BALLPIT_INSPECTION(extern, ballpit::Vec2);
BALLPIT_INSPECTION(extern, ballpit::Vec3);
BALLPIT_INSPECTION(extern, ballpit::Vec2d);
BALLPIT_INSPECTION(extern, ballpit::Vec3d);
