// SPDX-License-Identifier: MIT
// The kinematic response on the CPU.
#include "world/instances_cpu.h"
#include "world/kinematic_substepper.h"

namespace ballpit {

template std::unique_ptr<Substepper<Vec2, CpuExecutor>> make_kinematic_substepper(const Scene&, const Settings&);
template std::unique_ptr<Substepper<Vec3, CpuExecutor>> make_kinematic_substepper(const Scene&, const Settings&);
template std::unique_ptr<Substepper<Vec2d, CpuExecutor>> make_kinematic_substepper(const Scene&, const Settings&);
template std::unique_ptr<Substepper<Vec3d, CpuExecutor>> make_kinematic_substepper(const Scene&, const Settings&);

}  // namespace ballpit
