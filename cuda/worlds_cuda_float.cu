// SPDX-License-Identifier: MIT
// Worlds on an NVIDIA GPU in single precision.
#include "cuda_executor.h"
#include "world/force_motion.h"
#include "world/impulse_motion.h"
#include "world/kinematic_motion.h"
#include "world/position_motion.h"
#include "world/world_on.h"

namespace ballpit {

template std::unique_ptr<World> make_world_of<Vec2>(std::unique_ptr<CudaExecutor>, const Scene&, const Settings&);
template std::unique_ptr<World> make_world_of<Vec3>(std::unique_ptr<CudaExecutor>, const Scene&, const Settings&);

}  // namespace ballpit
