// SPDX-License-Identifier: MIT
// Detection on the CPU in double precision.
#include "world/instances_cpu.h"

BALLPIT_DETECTION(, ballpit::Vec2d);
BALLPIT_DETECTION(, ballpit::Vec3d);
