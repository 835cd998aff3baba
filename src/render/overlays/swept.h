// SPDX-License-Identifier: MIT
// Draws the path of each sphere until the next search for contacts: the space that it sweeps over, and where it arrives.
//
//       ╭────────────────────╮
//     ( o )· · · · · · · · ·( )     two sides, tinted between them, and a ring at the end
//       ╰────────────────────╯
//
// A search finds contacts at both ends of the path; only swept contacts are found in between. The velocity is the present
// one: forces during the step are ignored.
#pragma once

#include "render/frame_view.h"
#include "render/painter.h"

namespace ballpit {

/// The longest path, in diameters of its sphere: above 1, spheres may pass through each other. 0 without velocities.
float longest_way(const FrameView& view);

void draw_swept(const FrameView& view, Painter& painter);

}  // namespace ballpit
