// SPDX-License-Identifier: MIT
// The position-based response on the CPU.
#include "world/instances_cpu.h"
#include "world/position_motion.h"

namespace ballpit {

template std::unique_ptr<Motion<Vec2, CpuExecutor>> make_position_based_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec3, CpuExecutor>> make_position_based_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec2d, CpuExecutor>> make_position_based_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec3d, CpuExecutor>> make_position_based_motion(const Scene&, const Settings&);

}  // namespace ballpit
