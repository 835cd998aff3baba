// SPDX-License-Identifier: MIT
// The kinematic response on the CPU.
#include "world/instances_cpu.h"
#include "world/kinematic_motion.h"

namespace ballpit {

template std::unique_ptr<Motion<Vec2, CpuExecutor>> make_kinematic_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec3, CpuExecutor>> make_kinematic_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec2d, CpuExecutor>> make_kinematic_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec3d, CpuExecutor>> make_kinematic_motion(const Scene&, const Settings&);

}  // namespace ballpit
