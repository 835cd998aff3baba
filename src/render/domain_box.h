// SPDX-License-Identifier: MIT
// The box that holds all bodies: its floor, which grounds them, and its edges.
#pragma once

#include "render/frame_view.h"
#include "render/painter.h"

namespace ballpit {

/// Nothing in planar scenes, which have no floor to look at.
void draw_floor(const DomainBox& domain, Painter& painter);

/// Without a ceiling, the upright edges run on above the box and fade.
void draw_edges(const DomainBox& domain, Painter& painter);

}  // namespace ballpit
