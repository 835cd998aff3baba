// SPDX-License-Identifier: MIT
// Writes the number of each sphere at its centre, if the sphere is large enough and not hidden. In planar scenes with few
// cells also the number of each cell: in its lower left corner (slide 8), or in another one if a sphere lies there.
#pragma once

#include "render/frame_view.h"
#include "render/painter.h"

namespace ballpit {

void draw_labels(const FrameView& view, Painter& painter);

}  // namespace ballpit
