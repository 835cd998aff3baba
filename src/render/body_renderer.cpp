// SPDX-License-Identifier: MIT
#include "render/body_renderer.h"

#include <algorithm>

namespace ballpit {

namespace {

void draw_quads(const Shader& shader, const BodyBuffer& bodies, bool writes_depth) {
  shader.use();
  bodies.bind(BodyBuffer::Rate::body_per_instance);
  glDepthMask(writes_depth ? GL_TRUE : GL_FALSE);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(bodies.count()));
  glDepthMask(GL_TRUE);
}

/// Whether every sphere in the domain is smaller than a pixel and a half, so that a point shows it as well.
bool all_are_points(const BodyBuffer& bodies, const FrameView& view, int height) {
  constexpr float kSmallRadius = 1.5f;  // [pixel]
  const Camera& camera = view.camera;
  const Vec3 nearest = glm::clamp(camera.eye, view.domain.min, view.domain.max);
  const float distance = std::max(length(nearest - camera.eye), camera.near);
  return bodies.max_radius() < kSmallRadius * camera.pixel_size(distance, height);
}

}  // namespace

void BodyRenderer::draw(const BodyBuffer& bodies, const FrameView& view, int height) {
  if (view.domain.is_planar()) {
    draw_quads(disc_, bodies, false);
  } else if (all_are_points(bodies, view, height)) {
    point_.use();
    bodies.bind(BodyBuffer::Rate::body_per_vertex);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(bodies.count()));
  } else {
    draw_quads(shadow_, bodies, false);
    draw_quads(sphere_, bodies, true);
    draw_quads(outline_, bodies, false);
  }
}

}  // namespace ballpit
