// SPDX-License-Identifier: MIT
// Lines and faces in space, for overlays, floor and domain.
//
//     line: a quad of constant width that faces the viewer, with smooth edges (wide lines are optional in OpenGL)
//     face: a flat parallelogram in one colour
//
// Both may be translucent, so they are tested against the depth of what was drawn before but do not hide what comes later.
#pragma once

#include <cstdint>
#include <vector>

#include "render/shader.h"

namespace ballpit {

/// A colour as the GPU reads it, R in the lowest byte.
using Rgba = uint32_t;
Rgba to_rgba(const Vec3& color, float opacity = 1.0f);

/// The colour changes from one end to the other. The memory layout is the one that the vertex shader reads.
struct Line {
  Vec3 a;
  Rgba color_a;
  Vec3 b;
  Rgba color_b;
};

/// Corners: corner, corner + u, corner + v, corner + u + v. The memory layout is the one that the vertex shader reads.
struct Face {
  Vec3 corner, u, v;
  Rgba color;
};

class LineRenderer {
 public:
  /// `width` in pixels; a line thinner than one pixel becomes fainter instead.
  void draw(const std::vector<Line>& lines, float width);

 private:
  Shader shader_{"line.vert", "line.frag"};
  GlVertexArray no_attributes_;
  GlBuffer buffer_;
};

class FaceRenderer {
 public:
  FaceRenderer();
  void draw(const std::vector<Face>& faces);

 private:
  Shader shader_{"face.vert", "face.frag"};
  GlVertexArray vertex_array_;
  GlBuffer buffer_;
};

}  // namespace ballpit
