// SPDX-License-Identifier: MIT
// The linked-cell grid: occupied cells only, stronger where more bodies are.
//
//     spatial: edges of occupied cells        planar: tinted squares, and
//     (each edge once, however many           thin lines of all cells
//     cells share it); of thousands of          ┌──┬──┬──┐
//     cells their floors alone                  │  │▒▒│  │
//        ┌──┬──┐                                ├──┼──┼──┤
//        ├──┼──┘                                │░░│  │▓▓│
//        └──┘                                   └──┴──┴──┘
// Cost: proportional to the number of cells and bodies.
#pragma once

#include <vector>

#include "broad_phase/inspection.h"
#include "render/line_renderer.h"
#include "render/overlays/overlay.h"

namespace ballpit {

/// The number of bodies in every cell, found from head along next.
std::vector<int> count_per_cell(const GridInspection& grid);

class GridOverlay : public Overlay {
 public:
  void draw(const FrameView& view, Painter& painter, Layer layer) override;
};

}  // namespace ballpit
