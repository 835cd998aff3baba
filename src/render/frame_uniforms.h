// SPDX-License-Identifier: MIT
// The data that all shaders share while a picture is drawn: light, camera, colours (shaders/frame/frame.glsl).
#pragma once

#include "render/frame_view.h"
#include "render/gl_object.h"
#include "render/theme.h"

namespace ballpit {

class FrameUniforms {
 public:
  FrameUniforms();

  /// For a picture of this size [pixel]: for all shaders used from now on.
  void set(const FrameView& view, const Theme& theme, int width, int height);

 private:
  GlBuffer buffer_;
};

}  // namespace ballpit
