// SPDX-License-Identifier: MIT
// The impulse response on the CPU.
#include "world/impulse_substepper.h"
#include "world/instances_cpu.h"

namespace ballpit {

template std::unique_ptr<Substepper<Vec2, CpuExecutor>> make_impulse_substepper(const Scene&, const Settings&);
template std::unique_ptr<Substepper<Vec3, CpuExecutor>> make_impulse_substepper(const Scene&, const Settings&);
template std::unique_ptr<Substepper<Vec2d, CpuExecutor>> make_impulse_substepper(const Scene&, const Settings&);
template std::unique_ptr<Substepper<Vec3d, CpuExecutor>> make_impulse_substepper(const Scene&, const Settings&);

}  // namespace ballpit
