// SPDX-License-Identifier: MIT
#include "render/line_renderer.h"

#include <cmath>

namespace ballpit {

Rgba to_rgba(const Vec3& color, float opacity) {
  const auto byte = [](float x) { return static_cast<Rgba>(std::lround(std::fmin(std::fmax(x, 0.0f), 1.0f) * 255)); };
  return byte(color.r) | byte(color.g) << 8 | byte(color.b) << 16 | byte(opacity) << 24;
}

LineRenderer::LineRenderer() : shader_("line.vert", "line.frag") { static_assert(sizeof(Line) == 32); }

void LineRenderer::draw(const std::vector<Line>& lines, float width) {
  if (lines.empty()) return;
  glNamedBufferData(buffer_.name(), static_cast<GLsizeiptr>(lines.size() * sizeof(Line)), lines.data(), GL_STREAM_DRAW);
  shader_.set("width", width);
  shader_.use();
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffer_.name());
  glBindVertexArray(no_attributes_.name());
  glDepthMask(GL_FALSE);  // lines may be translucent: they hide nothing
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * lines.size()));
  glDepthMask(GL_TRUE);
}

}  // namespace ballpit
