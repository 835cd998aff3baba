// SPDX-License-Identifier: MIT
// Marks the selected sphere with a ring, and the block of 3 × 3 (× 3) cells that is searched for its contacts (slide 10).
#pragma once

#include <optional>

#include "bodies/body_snapshot.h"
#include "broad_phase/inspection.h"
#include "render/frame_view.h"
#include "render/painter.h"

namespace ballpit {

/// Cells from `low` (included) to `high` (excluded).
struct Block {
  IVec3 low, high;
};

/// The cells around the one that lists the body, without those outside of the grid; none if the grid does not list it.
std::optional<Block> block_around(const GridInspection& grid, const BodySnapshot& bodies, int64_t body);

/// Draws nothing unless a body is selected.
void draw_selection(const FrameView& view, Painter& painter);

}  // namespace ballpit
