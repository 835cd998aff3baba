// SPDX-License-Identifier: MIT
// Shows the arrays in which a method stores its cells. Linked lists (slides 12 to 15): per cell the first body, per body the
// next one.
//
//             0    1    2    3    4
//     head  │ −1 │  2 │ −1 │ −1 │ −1 │      cell 1 holds bodies 2 and 0
//                  │
//             0    ▼ 1    2
//     next  │ −1 │ −1 │  0 │                drawn: head[1] → 2, and 2 → 0 in an arc below
//             ▲─────────╯
//
// Sorted by cell: per cell the begin of its range of bodies; the last entry is the end of the last range.
//
//               0    1    2    3
//     offsets │  0 │  0 │  2 │  3 │         cell 1 holds bodies 4 and 0
//                     │
//               0     ▼ 1    2
//     bodies  │  4 │  0 │  7 │
//              └───────┘
//
// A hashed grid has places of a table instead of cells. If there are more entries or bodies than fit in a row, a histogram
// shows the lengths of the lists or ranges instead.
#pragma once

#include <vector>

#include "broad_phase/inspection.h"
#include "render/frame_view.h"
#include "render/painter.h"
#include "world/inspection.h"

namespace ballpit {

/// Entry k: the number of cells, or places of a table, whose list or range has k bodies; entry `max` also counts longer ones.
std::vector<int> count_lengths(const GridInspection& grid, size_t max);

/// The part of the picture's height that the arrays fill.
float lists_room(const Inspection& inspection);

void draw_lists(const FrameView& view, Painter& painter);

}  // namespace ballpit
