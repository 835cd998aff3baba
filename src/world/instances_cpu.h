// SPDX-License-Identifier: MIT
// Detection on the CPU, compiled by detection_cpu_*.cpp.
#pragma once

#include "exec/cpu_executor.h"
#include "world/instances.h"

BALLPIT_DETECTION(extern, ballpit::Vec2, ballpit::CpuExecutor);
BALLPIT_DETECTION(extern, ballpit::Vec3, ballpit::CpuExecutor);
BALLPIT_DETECTION(extern, ballpit::Vec2d, ballpit::CpuExecutor);
BALLPIT_DETECTION(extern, ballpit::Vec3d, ballpit::CpuExecutor);
