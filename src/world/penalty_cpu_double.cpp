// SPDX-License-Identifier: MIT
// The penalty response on the CPU in double precision.
#include "world/force_motion.h"
#include "world/instances_cpu.h"

namespace ballpit {

template std::unique_ptr<Motion<Vec2d, CpuExecutor>> make_penalty_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec3d, CpuExecutor>> make_penalty_motion(const Scene&, const Settings&);

}  // namespace ballpit
