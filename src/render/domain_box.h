// SPDX-License-Identifier: MIT
// Draws the box that holds all bodies: its floor and its edges.
#pragma once

#include "render/frame_view.h"
#include "render/painter.h"

namespace ballpit {

/// Draws nothing in planar scenes, which have no floor.
void draw_floor(const DomainBox& domain, Painter& painter);

/// Without a ceiling, the upright edges continue above the box and fade.
void draw_edges(const DomainBox& domain, Painter& painter);

}  // namespace ballpit
