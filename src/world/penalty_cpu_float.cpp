// SPDX-License-Identifier: MIT
// The penalty response on the CPU in single precision.
#include "world/force_motion.h"
#include "world/instances_cpu.h"

namespace ballpit {

template std::unique_ptr<Motion<Vec2, CpuExecutor>> make_penalty_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec3, CpuExecutor>> make_penalty_motion(const Scene&, const Settings&);

}  // namespace ballpit
