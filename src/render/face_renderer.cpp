// SPDX-License-Identifier: MIT
#include "render/face_renderer.h"

namespace ballpit {

FaceRenderer::FaceRenderer() : shader_("face.vert", "face.frag") {
  static_assert(sizeof(Face) == 40);
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
  glNamedBufferData(buffer_.name(), static_cast<GLsizeiptr>(faces.size() * sizeof(Face)), faces.data(), GL_STREAM_DRAW);
  shader_.use();
  glBindVertexArray(vertex_array_.name());
  glDepthMask(GL_FALSE);  // faces may be translucent: they hide nothing
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(faces.size()));
  glDepthMask(GL_TRUE);
}

}  // namespace ballpit
