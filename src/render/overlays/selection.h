// SPDX-License-Identifier: MIT
// Where a sphere's contacts are sought (slide 10): the selected sphere with a ring, and its block of 3 × 3 (× 3) cells.
#pragma once

#include <optional>

#include "bodies/body_snapshot.h"
#include "broad_phase/inspection.h"
#include "render/frame_view.h"
#include "render/painter.h"

namespace ballpit {

/// Cells from `low` up to, but without, `high`.
struct Block {
  IVec3 low, high;
};

/// The cells around the one that lists the body, as far as the grid goes; none if the grid does not list it.
std::optional<Block> block_around(const GridInspection& grid, const BodySnapshot& bodies, int64_t body);

/// Draws nothing unless a body is selected.
void draw_selection(const FrameView& view, Painter& painter);

}  // namespace ballpit
