// SPDX-License-Identifier: MIT
// Numbers: of each sphere at its centre, where it is large enough and not hidden; of each cell in its lower left corner,
// in planar scenes of few cells (slide 8), or in another corner if a sphere lies there.
#pragma once

#include "render/overlays/overlay.h"

namespace ballpit {

class LabelsOverlay : public Overlay {
 public:
  void draw(const FrameView& view, Painter& painter, Layer layer) override;
};

}  // namespace ballpit
