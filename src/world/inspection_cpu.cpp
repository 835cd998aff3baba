// SPDX-License-Identifier: MIT
// What the audience sees of a world on the CPU.
#include "world/instances_cpu.h"

BALLPIT_INSPECTION(, ballpit::Vec2);
BALLPIT_INSPECTION(, ballpit::Vec3);
BALLPIT_INSPECTION(, ballpit::Vec2d);
BALLPIT_INSPECTION(, ballpit::Vec3d);
