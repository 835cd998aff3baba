// SPDX-License-Identifier: MIT
// The linked lists of cells in memory (slides 12 to 15): per cell its first body, per body the next one.
//
//             0    1    2    3    4
//     head  │ −1 │  2 │ −1 │ −1 │ −1 │      cell 1 holds bodies 2 and 0
//                  │
//             0    ▼ 1    2
//     next  │ −1 │ −1 │  0 │                drawn: head[1] → 2, and 2 → 0 in an arc below
//             ▲─────────╯
//
// With more cells or bodies than fit a row: how many cells have a list of which length.
#pragma once

#include <vector>

#include "render/overlays/overlay.h"

namespace ballpit {

/// [k]: cells whose list has k bodies; the last entry also counts longer ones.
std::vector<int> count_lengths(const GridInspection& grid, size_t most);

float lists_room(const Inspection& inspection);

class ListsOverlay : public Overlay {
 public:
  void draw(const FrameView& view, Painter& painter, Layer layer) override;
};

}  // namespace ballpit
