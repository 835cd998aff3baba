// SPDX-License-Identifier: MIT
// Detection on the CPU in single precision.
#include "exec/cpu_executor.h"
#include "world/instances.h"

BALLPIT_DETECTION(, ballpit::Vec2, ballpit::CpuExecutor);
BALLPIT_DETECTION(, ballpit::Vec3, ballpit::CpuExecutor);
