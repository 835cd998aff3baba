// SPDX-License-Identifier: MIT
// Flat parallelograms in one colour each: the floor, cells of planar grids, tinted faces.
#pragma once

#include <vector>

#include "render/gl_object.h"
#include "render/line_renderer.h"
#include "render/shader.h"

namespace ballpit {

/// corner, corner + u, corner + v, corner + u + v; laid out as the vertex shader reads it.
struct Face {
  Vec3 corner;
  Vec3 u;
  Vec3 v;
  Rgba color;
};

class FaceRenderer {
 public:
  FaceRenderer();
  void draw(const std::vector<Face>& faces);

 private:
  Shader shader_;
  GlVertexArray vertex_array_;
  GlBuffer buffer_;
};

}  // namespace ballpit
