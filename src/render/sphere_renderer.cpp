// SPDX-License-Identifier: MIT
#include "render/sphere_renderer.h"

#include <algorithm>

namespace ballpit {

namespace {

void draw_quads(const BodyBuffer& bodies) {
  bodies.bind(BodyBuffer::Rate::body_per_instance);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(bodies.count()));
}

}  // namespace

bool all_are_points(const BodyBuffer& bodies, const FrameView& view, int height) {
  constexpr float kSmallRadius = 1.5f;  // [pixel]
  const Camera& camera = view.camera;
  const Vec3 nearest = glm::clamp(camera.eye, view.domain.min, view.domain.max);
  const float distance = std::max(length(nearest - camera.eye), camera.near);
  return bodies.max_radius() < kSmallRadius * camera.pixel_size(distance, height);
}

SphereRenderer::SphereRenderer()
    : sphere_("sphere.vert", "sphere.frag"),
      outline_("outline.vert", "outline.frag"),
      point_("point.vert", "point.frag"),
      shadow_("shadow.vert", "shadow.frag") {}

void SphereRenderer::draw_shadows(const BodyBuffer& bodies) {
  shadow_.use();
  glDepthMask(GL_FALSE);
  draw_quads(bodies);
  glDepthMask(GL_TRUE);
}

void SphereRenderer::draw(const BodyBuffer& bodies, const FrameView& view, int height) {
  if (all_are_points(bodies, view, height)) {
    point_.use();
    bodies.bind(BodyBuffer::Rate::body_per_vertex);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(bodies.count()));
    return;
  }
  sphere_.use();
  draw_quads(bodies);
  outline_.use();
  glDepthMask(GL_FALSE);
  draw_quads(bodies);
  glDepthMask(GL_TRUE);
}

}  // namespace ballpit
