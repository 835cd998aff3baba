// SPDX-License-Identifier: MIT
// What all programs know of the picture being drawn: the other side of shaders/frame/frame.glsl (layout
// std140).
#pragma once

#include "render/body_buffer.h"
#include "render/frame_view.h"
#include "render/gl_object.h"
#include "render/theme.h"

namespace ballpit {

struct FrameUniforms {
  Mat4 view;
  Mat4 projection;
  Vec4 key_light;
  Vec4 halfway;
  Vec4 sky;
  Vec4 units;
  Vec4 shadow;
  Vec4 background;
  Vec4 mark_color[2 + kScaleColors];
  Vec2 viewport;
  float pixel;
  float line_unit;
};

FrameUniforms frame_uniforms(const FrameView& view, const Theme& theme, int width, int height);

class FrameUniformBuffer {
 public:
  FrameUniformBuffer();
  void set(const FrameUniforms& uniforms);  ///< for all programs used from now on

 private:
  GlBuffer buffer_;
};

}  // namespace ballpit
