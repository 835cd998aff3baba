// SPDX-License-Identifier: MIT
#include "render/render_target.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "render/gl_debug.h"

namespace ballpit {

namespace {

/// Returns `side`. Throws UserError unless the device can draw pictures of that size.
int checked_side(int width, int height, int side) {
  GLint texture = 0;
  GLint viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const int largest = std::min({texture, viewport[0], viewport[1]});
  if (width >= 1 && height >= 1 && width <= largest && height <= largest) return side;
  throw UserError("--size", fmt::format("{}x{} pixels, supersampling included", width, height),
                  fmt::format("sides of 1 to {} pixels here", largest));
}

}  // namespace

RenderTarget::RenderTarget(int width, int height)
    : width_(checked_side(width, height, width)), height_(checked_side(width, height, height)) {
  glTextureStorage2D(color_.name(), 1, GL_RGBA8, width_, height_);
  glTextureStorage2D(depth_.name(), 1, GL_DEPTH_COMPONENT32F, width_, height_);
  check_gl(fmt::format("making a picture of {}x{} pixels", width, height));
  glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, color_.name(), 0);
  glNamedFramebufferTexture(framebuffer_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
  const GLenum status = glCheckNamedFramebufferStatus(framebuffer_.name(), GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw RunError("OpenGL", fmt::format("cannot draw into the picture: framebuffer status {}", status));
  }
}

void RenderTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, width_, height_);
}

}  // namespace ballpit
