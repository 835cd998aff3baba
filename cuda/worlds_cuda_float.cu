// SPDX-License-Identifier: MIT
// Worlds on an NVIDIA GPU in single precision.
#include "cuda_executor.h"
#include "simulate/force_substepper.h"
#include "simulate/position_substepper.h"
#include "simulate/response/impulse_substepper.h"
#include "simulate/response/kinematic_substepper.h"
#include "simulate/world_on.h"

namespace ballpit {

template std::unique_ptr<World> make_world_of<Vec2>(std::unique_ptr<CudaExecutor>, const Scene&, const Settings&);
template std::unique_ptr<World> make_world_of<Vec3>(std::unique_ptr<CudaExecutor>, const Scene&, const Settings&);

}  // namespace ballpit
