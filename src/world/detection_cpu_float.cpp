// SPDX-License-Identifier: MIT
// Detection on the CPU in single precision.
#include "world/instances_cpu.h"

BALLPIT_DETECTION(, ballpit::Vec2);
BALLPIT_DETECTION(, ballpit::Vec3);
