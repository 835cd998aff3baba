// SPDX-License-Identifier: MIT
// The penalty response on the CPU in single precision.
#include "world/force_substepper.h"
#include "world/instances_cpu.h"

namespace ballpit {

template std::unique_ptr<Substepper<Vec2, CpuExecutor>> make_penalty_substepper(const Scene&, const Settings&);
template std::unique_ptr<Substepper<Vec3, CpuExecutor>> make_penalty_substepper(const Scene&, const Settings&);

}  // namespace ballpit
