// SPDX-License-Identifier: MIT
// What overlays draw with.
#pragma once

#include "render/face_renderer.h"
#include "render/line_renderer.h"
#include "render/sheet.h"
#include "render/theme.h"

namespace ballpit {

struct Painter {
  LineRenderer& lines;
  FaceRenderer& faces;
  Sheet& sheet;  ///< in pixels of the picture, before all that is drawn in space
  const Theme& theme;
  float line_unit;  ///< [pixel] 1/1080 of the picture's height, so that every size of picture is the same
                    ///< design
};

}  // namespace ballpit
