// SPDX-License-Identifier: MIT
// The way that each sphere takes until contacts are sought again: what it sweeps over, and where it arrives.
//
//       ╭────────────────────╮
//     ( o )· · · · · · · · ·( )     two sides, tinted between them, and a ring at the end
//       ╰────────────────────╯
//
// Contacts are found where spheres are, at both ends; what lies between is met by swept contacts alone. Velocities are those of
// now: what forces change on the way is left out.
#pragma once

#include "render/overlays/overlay.h"

namespace ballpit {

/// The longest way of all, in diameters of its sphere: above 1 spheres may pass through each other. 0 without velocities.
float longest_way(const FrameView& view);

class SweptOverlay : public Overlay {
 public:
  void draw(const FrameView& view, Painter& painter, Layer layer) override;
};

}  // namespace ballpit
