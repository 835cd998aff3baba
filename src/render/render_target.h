// SPDX-License-Identifier: MIT
// A framebuffer to draw a picture into, with textures for colour and depth.
#pragma once

#include "render/gl_object.h"

namespace ballpit {

class RenderTarget {
 public:
  /// Throws UserError if the device cannot draw pictures of that size.
  RenderTarget(int width, int height);

  void bind() const;  ///< directs drawing to the whole picture

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
