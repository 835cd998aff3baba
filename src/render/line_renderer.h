// SPDX-License-Identifier: MIT
// Lines of any width with smooth edges: each a quad that faces the viewer. OpenGL's own wide lines are
// optional.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_object.h"
#include "render/shader.h"

namespace ballpit {

/// A colour as the GPU reads it, R in the lowest byte.
using Rgba = uint32_t;
Rgba to_rgba(const Vec3& color, float opacity = 1.0f);

/// The colour runs from one end to the other; laid out as the vertex shader reads it.
struct Line {
  Vec3 a;
  Rgba color_a;
  Vec3 b;
  Rgba color_b;
};

class LineRenderer {
 public:
  LineRenderer();

  /// `width` in pixels; thinner than one pixel becomes fainter instead.
  void draw(const std::vector<Line>& lines, float width);

 private:
  Shader shader_;
  GlVertexArray no_attributes_;
  GlBuffer buffer_;
};

}  // namespace ballpit
