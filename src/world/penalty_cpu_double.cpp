// SPDX-License-Identifier: MIT
// The penalty response on the CPU in double precision.
#include "world/force_substepper.h"
#include "world/instances_cpu.h"

namespace ballpit {

template std::unique_ptr<Substepper<Vec2d, CpuExecutor>> make_penalty_substepper(const Scene&, const Settings&);
template std::unique_ptr<Substepper<Vec3d, CpuExecutor>> make_penalty_substepper(const Scene&, const Settings&);

}  // namespace ballpit
