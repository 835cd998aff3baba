// SPDX-License-Identifier: MIT
// Detection on the CPU in double precision.
#include "exec/cpu_executor.h"
#include "simulate/instances.h"

BALLPIT_DETECTION(, ballpit::Vec2d, ballpit::CpuExecutor);
BALLPIT_DETECTION(, ballpit::Vec3d, ballpit::CpuExecutor);
