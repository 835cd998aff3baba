// SPDX-License-Identifier: MIT
// How spheres move: an arrow along each velocity, from the centre. The fastest one's is a twelfth of the picture long;
// a note tells its speed.
#pragma once

#include "render/overlays/overlay.h"

namespace ballpit {

/// [s] How long a sphere flies along its arrow; 0 where all are at rest.
float arrow_time(const FrameView& view);

class VelocityOverlay : public Overlay {
 public:
  void draw(const FrameView& view, Painter& painter, Layer layer) override;
};

}  // namespace ballpit
