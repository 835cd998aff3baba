// SPDX-License-Identifier: MIT
// Detection on the CPU in double precision.
#include "exec/cpu_executor.h"
#include "world/instances.h"

BALLPIT_DETECTION(, ballpit::Vec2d, ballpit::CpuExecutor);
BALLPIT_DETECTION(, ballpit::Vec3d, ballpit::CpuExecutor);
