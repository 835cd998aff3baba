// SPDX-License-Identifier: MIT
#include "render/line_renderer.h"

#include <cmath>

namespace ballpit {

Rgba to_rgba(const Vec3& color, float opacity) {
  const auto byte = [](float x) { return static_cast<Rgba>(std::lround(std::fmin(std::fmax(x, 0.0f), 1.0f) * 255)); };
  return byte(color.r) | byte(color.g) << 8 | byte(color.b) << 16 | byte(opacity) << 24;
}

LineRenderer::LineRenderer() : shader_("line.vert", "line.frag") {
  static_assert(sizeof(Line) == 32);
  const GLuint array = vertex_array_.name();
  glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, offsetof(Line, a));
  glVertexArrayAttribFormat(array, 1, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Line, color_a));
  glVertexArrayAttribFormat(array, 2, 3, GL_FLOAT, GL_FALSE, offsetof(Line, b));
  glVertexArrayAttribFormat(array, 3, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Line, color_b));
  for (GLuint attribute = 0; attribute < 4; ++attribute) {
    glVertexArrayAttribBinding(array, attribute, 0);
    glEnableVertexArrayAttrib(array, attribute);
  }
  glVertexArrayVertexBuffer(array, 0, buffer_.name(), 0, sizeof(Line));
  glVertexArrayBindingDivisor(array, 0, 1);
}

void LineRenderer::draw(const std::vector<Line>& lines, float width) {
  if (lines.empty()) return;
  glNamedBufferData(buffer_.name(), static_cast<GLsizeiptr>(lines.size() * sizeof(Line)), lines.data(), GL_STREAM_DRAW);
  shader_.set("width", width);
  shader_.use();
  glBindVertexArray(vertex_array_.name());
  glDepthMask(GL_FALSE);  // lines may be translucent: they hide nothing
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(lines.size()));
  glDepthMask(GL_TRUE);
}

}  // namespace ballpit
