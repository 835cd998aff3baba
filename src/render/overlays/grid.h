// SPDX-License-Identifier: MIT
// Draws the cells of a grid that hold bodies, stronger the more bodies they hold.
//
//     spatial: edges of occupied cells        planar: tinted squares, and
//     (an edge of several cells               thin lines of all cells
//     is drawn once); for thousands             ┌──┬──┬──┐
//     of cells only their floors                │  │▒▒│  │
//        ┌──┬──┐                                ├──┼──┼──┤
//        ├──┼──┘                                │░░│  │▓▓│
//        └──┘                                   └──┴──┴──┘
// Cost: proportional to the number of cells and bodies.
#pragma once

#include <vector>

#include "broad_phase/inspection.h"
#include "render/frame_view.h"
#include "render/painter.h"

namespace ballpit {

/// The number of bodies in every cell: the length of its list.
std::vector<int> count_per_cell(const GridInspection& grid);

void draw_grid(const FrameView& view, Painter& painter);

}  // namespace ballpit
