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

/// Visits the edges that begin at the first `corners` of a box's 8: their starts, and the vectors along them, to larger
/// coordinates. In the plane 4 corners begin all edges; 8 visit each twice.
template <class Visit>
void for_each_edge(const Vec3& low, const Vec3& size, int corners, Visit&& visit) {
  for (int corner = 0; corner < corners; ++corner) {
    const Vec3 part(corner & 1, corner >> 1 & 1, corner >> 2);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 along(0);
      along[axis] = size[axis];
      if (part[axis] == 0 && size[axis] > 0) visit(low + part * size, along);
    }
  }
}

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
