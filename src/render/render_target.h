// SPDX-License-Identifier: MIT
// Where a picture is drawn: colour and depth in textures of a framebuffer.
#pragma once

#include "render/gl_object.h"

namespace ballpit {

class RenderTarget {
 public:
  /// Throws UserError if the device cannot draw pictures of that size.
  RenderTarget(int width, int height);

  void bind() const;  ///< draws go here, to all of it

  GLuint framebuffer() const { return framebuffer_.name(); }
  GLuint color() const { return color_.name(); }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_;
  int height_;
  GlTexture color_;
  GlTexture depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace ballpit
