// SPDX-License-Identifier: MIT
// What a method keeps of its cells in memory. Linked lists (slides 12 to 15): per cell its first body, per body the
// next one.
//
//             0    1    2    3    4
//     head  │ −1 │  2 │ −1 │ −1 │ −1 │      cell 1 holds bodies 2 and 0
//                  │
//             0    ▼ 1    2
//     next  │ −1 │ −1 │  0 │                drawn: head[1] → 2, and 2 → 0 in an arc below
//             ▲─────────╯
//
// Sorted by cell: per cell where its range of bodies begins; the last entry ends the last range.
//
//               0    1    2    3
//     offsets │  0 │  0 │  2 │  3 │         cell 1 holds bodies 4 and 0
//                     │
//               0     ▼ 1    2
//     bodies  │  4 │  0 │  7 │
//              └───────┘
//
// A hashed grid has places of a table instead of cells. With more entries or bodies than fit a row: how many entries
// have a list or range of which length.
#pragma once

#include <vector>

#include "broad_phase/inspection.h"
#include "render/overlays/overlay.h"
#include "world/inspection.h"

namespace ballpit {

/// [k]: cells, or places of a table, whose list or range has k bodies; the last entry also counts longer ones.
std::vector<int> count_lengths(const GridInspection& grid, size_t most);

float lists_room(const Inspection& inspection);

class ListsOverlay : public Overlay {
 public:
  void draw(const FrameView& view, Painter& painter, Layer layer) override;
};

}  // namespace ballpit
