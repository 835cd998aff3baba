// SPDX-License-Identifier: MIT
// Draws an arrow along each velocity, from the centre of the sphere. The longest arrow is a twelfth of the picture's height;
// a note gives its speed.
#pragma once

#include "render/frame_view.h"
#include "render/painter.h"

namespace ballpit {

/// [s] How long a sphere needs for the length of its arrow; 0 if all are at rest.
float arrow_time(const FrameView& view);

void draw_velocities(const FrameView& view, Painter& painter);

}  // namespace ballpit
