// SPDX-License-Identifier: MIT
// Worlds on the CPU.
#include "world/instances_cpu.h"
#include "world/world_on.h"

namespace ballpit {

template std::unique_ptr<World> make_world_of<Vec2>(std::unique_ptr<CpuExecutor>, const Scene&, const Settings&);
template std::unique_ptr<World> make_world_of<Vec3>(std::unique_ptr<CpuExecutor>, const Scene&, const Settings&);
template std::unique_ptr<World> make_world_of<Vec2d>(std::unique_ptr<CpuExecutor>, const Scene&, const Settings&);
template std::unique_ptr<World> make_world_of<Vec3d>(std::unique_ptr<CpuExecutor>, const Scene&, const Settings&);

}  // namespace ballpit
