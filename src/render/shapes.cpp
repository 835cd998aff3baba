// SPDX-License-Identifier: MIT
#include "render/shapes.h"

#include <cmath>
#include <cstddef>

namespace ballpit {

static_assert(sizeof(Line) == 32 && sizeof(Face) == 40, "the shaders read them from memory");

namespace {

template <class Shape>
void upload(const GlBuffer& buffer, const std::vector<Shape>& shapes) {
  const auto bytes = static_cast<GLsizeiptr>(shapes.size() * sizeof(Shape));
  glNamedBufferData(buffer.name(), bytes, shapes.data(), GL_STREAM_DRAW);
}

}  // namespace

Rgba to_rgba(const Vec3& color, float opacity) {
  const auto byte = [](float x) { return static_cast<Rgba>(std::lround(std::fmin(std::fmax(x, 0.0f), 1.0f) * 255)); };
  return byte(color.r) | byte(color.g) << 8 | byte(color.b) << 16 | byte(opacity) << 24;
}

void LineRenderer::draw(const std::vector<Line>& lines, float width) {
  if (lines.empty()) return;
  upload(buffer_, lines);
  shader_.set("width", width);
  shader_.use();
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffer_.name());
  glBindVertexArray(no_attributes_.name());
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * lines.size()));
  glDepthMask(GL_TRUE);
}

FaceRenderer::FaceRenderer() {
  const GLuint array = vertex_array_.name();
  glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, offsetof(Face, corner));
  glVertexArrayAttribFormat(array, 1, 3, GL_FLOAT, GL_FALSE, offsetof(Face, u));
  glVertexArrayAttribFormat(array, 2, 3, GL_FLOAT, GL_FALSE, offsetof(Face, v));
  glVertexArrayAttribFormat(array, 3, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Face, color));
  for (GLuint attribute = 0; attribute < 4; ++attribute) {
    glVertexArrayAttribBinding(array, attribute, 0);
    glEnableVertexArrayAttrib(array, attribute);
  }
  glVertexArrayVertexBuffer(array, 0, buffer_.name(), 0, sizeof(Face));
  glVertexArrayBindingDivisor(array, 0, 1);
}

void FaceRenderer::draw(const std::vector<Face>& faces) {
  if (faces.empty()) return;
  upload(buffer_, faces);
  shader_.use();
  glBindVertexArray(vertex_array_.name());
  glDepthMask(GL_FALSE);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(faces.size()));
  glDepthMask(GL_TRUE);
}

}  // namespace ballpit
