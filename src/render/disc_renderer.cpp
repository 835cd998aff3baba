// SPDX-License-Identifier: MIT
#include "render/disc_renderer.h"

namespace ballpit {

DiscRenderer::DiscRenderer() : shader_("disc.vert", "disc.frag") {}

void DiscRenderer::draw(const BodyBuffer& bodies) {
  shader_.use();
  bodies.bind(BodyBuffer::Rate::body_per_instance);
  glDepthMask(GL_FALSE);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(bodies.count()));
  glDepthMask(GL_TRUE);
}

}  // namespace ballpit
