// SPDX-License-Identifier: MIT
// Shows sort and sweep (slides 2 to 4): the axis beside the scene, the begin and end of each sphere on it, the sorted list
// and the walk of one thread along that list.
//
//          ( 0 )  ( 1 )
//          ⋮   ⋮  ⋮   ⋮                dotted: from a sphere's ends to the axis
//     ─────[───]──[───]─────▶ x        begin: a filled bracket; end: a hollow one
//          b0  e0 b1  e1
//     ┌──┬──┬──┬──┐
//     │b0│e0│b1│e1│                    the list: begins that the walk meets are sky, ends are grey
//     └──┴──┴──┴──┘
//
// With many spheres there is only room for the brackets. Cost: proportional to the number of spheres.
#pragma once

#include "render/frame_view.h"
#include "render/painter.h"
#include "world/inspection.h"

namespace ballpit {

/// The part of the picture's height that axis and list fill.
float intervals_room(const Inspection& inspection);

void draw_intervals(const FrameView& view, Painter& painter);

}  // namespace ballpit
