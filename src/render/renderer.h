// SPDX-License-Identifier: MIT
// Draws one view into a picture of fixed size: floor, bodies, overlays, domain.
// Needs a current OpenGL 4.5 context, made by GlContext or by a window, from its making to its end.
#pragma once

#include <memory>

#include "render/body_buffer.h"
#include "render/frame_view.h"
#include "render/image.h"
#include "render/sheet.h"
#include "render/theme.h"

namespace ballpit {

struct RenderOptions {
  Theme theme = themes().front();
  int supersample = 1;  ///< 1 to 4: draws that many times larger each way and averages, for stills
  int left = 0;         ///< [pixel] of the picture's width that are left to a panel
};

class Renderer {
 public:
  /// Throws UserError for sizes that no picture has or that the device cannot draw.
  Renderer(int width, int height, const RenderOptions& options = {});
  ~Renderer();

  /// Leaves the finished picture's framebuffer bound and its viewport set, so that a panel can draw over it.
  /// Throws RunError with OpenGL's message if drawing failed.
  void draw(const FrameView& view);

  /// The picture as drawn so far, rows from top to bottom.
  Image read_pixels();

  /// Copies the picture to the window's framebuffer.
  void copy_to_window();

  int width() const;
  int height() const;

  /// What is drawn, for a BodyWriter.
  BodyBuffer& bodies();

  /// What text is drawn on; a panel shares it.
  Sheet& sheet();

  /// Restyles or resizes; everything that is shown stays as it is.
  void set_options(const RenderOptions& options);
  void resize(int width, int height);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ballpit
