// SPDX-License-Identifier: MIT
#include "render/small_spheres.h"

#include <cmath>

namespace ballpit {

namespace {

constexpr int64_t kMany = 2000;         // spheres
constexpr float kSmallestPoint = 1.5f;  // [pixel] radius of the largest; below, BodyRenderer has simpler points
constexpr float kLargestPoint = 16;     // [pixel] OpenGL's points are limited, llvmpipe's to 255 pixels across
constexpr float kPointMargin =
    24;  // [pixel] around the view: more than the half of a point, outline and ellipse included

/// Of the uniforms of small.vert.
void set_uniforms(const Shader& shader, float beyond) {
  shader.set("beyond", beyond);
  shader.set("margin", kPointMargin);
}

}  // namespace

SmallSphereRenderer::SmallSphereRenderer(bool leaves_out_hidden) : leaves_out_hidden_(leaves_out_hidden) {
  set_uniforms(sphere_, -0.5f);
  set_uniforms(outline_, 0.5f);
  const GLuint array = shadow_array_.name();
  glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribFormat(array, 1, 1, GL_FLOAT, GL_FALSE, sizeof(Vec3));
  glVertexArrayVertexBuffer(array, 0, shadows_.name(), 0, sizeof(Vec4));
  glVertexArrayBindingDivisor(array, 0, 1);
  for (GLuint attribute : {0u, 1u}) {
    glVertexArrayAttribBinding(array, attribute, 0);
    glEnableVertexArrayAttrib(array, attribute);
  }
}

bool SmallSphereRenderer::suits(const BodyBuffer& bodies, const FrameView& view, int height) {
  const float radius = nearest_radius(bodies, view, height);
  return !view.domain.is_planar() && bodies.count() >= kMany && radius >= kSmallestPoint && radius < kLargestPoint;
}

void SmallSphereRenderer::draw(const BodyBuffer& bodies, const FrameView& view) {
  GLint part[4];
  glGetIntegerv(GL_VIEWPORT, part);
  const bool was_cut = glIsEnabled(GL_SCISSOR_TEST);
  SeenSpheres seen;
  auto count = static_cast<GLsizei>(bodies.count());
  if (leaves_out_hidden_) {
    seen = find_seen(bodies.read(), view, part[2], part[3]);
    count = static_cast<GLsizei>(seen.nearest_first.size());
    draw_shadows(seen.near_floor);
  } else {
    draw_quads(shadow_, bodies, false);
  }
  bodies.bind(0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements_.name());
  const auto draw_points = [&] {
    const std::vector<uint32_t>& order = seen.nearest_first;
    if (!leaves_out_hidden_) return glDrawArrays(GL_POINTS, 0, count);
    glNamedBufferData(elements_.name(), static_cast<GLsizeiptr>(order.size() * sizeof(uint32_t)), order.data(),
                      GL_STREAM_DRAW);
    glDrawElements(GL_POINTS, count, GL_UNSIGNED_INT, nullptr);
  };
  constexpr int kRoom = static_cast<int>(kPointMargin);
  glEnable(GL_SCISSOR_TEST);
  if (!was_cut) glScissor(part[0], part[1], part[2], part[3]);
  glViewport(part[0] - kRoom, part[1] - kRoom, part[2] + 2 * kRoom, part[3] + 2 * kRoom);
  for (const Shader* shader : {&sphere_, &outline_}) shader->set("nearer", bodies.max_radius());
  sphere_.use();
  glDisable(GL_BLEND);
  draw_points();
  glEnable(GL_BLEND);
  std::reverse(seen.nearest_first.begin(), seen.nearest_first.end());
  outline_.use();
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_LESS);  // not where the sphere itself is
  draw_points();
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glViewport(part[0], part[1], part[2], part[3]);
  if (!was_cut) glDisable(GL_SCISSOR_TEST);
}

void SmallSphereRenderer::draw_shadows(const std::vector<Vec4>& spheres) {
  if (spheres.empty()) return;
  glNamedBufferData(shadows_.name(), static_cast<GLsizeiptr>(spheres.size() * sizeof(Vec4)), spheres.data(),
                    GL_STREAM_DRAW);
  shadow_.use();
  glBindVertexArray(shadow_array_.name());
  glDepthMask(GL_FALSE);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(spheres.size()));
  glDepthMask(GL_TRUE);
}

}  // namespace ballpit
