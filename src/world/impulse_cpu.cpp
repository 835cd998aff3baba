// SPDX-License-Identifier: MIT
// The impulse response on the CPU.
#include "world/impulse_motion.h"
#include "world/instances_cpu.h"

namespace ballpit {

template std::unique_ptr<Motion<Vec2, CpuExecutor>> make_impulse_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec3, CpuExecutor>> make_impulse_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec2d, CpuExecutor>> make_impulse_motion(const Scene&, const Settings&);
template std::unique_ptr<Motion<Vec3d, CpuExecutor>> make_impulse_motion(const Scene&, const Settings&);

}  // namespace ballpit
