// SPDX-License-Identifier: MIT
// Draws one view into a picture of fixed size: floor, bodies, overlays, domain.
// Needs a current OpenGL 4.5 context, made by GlContext or by a window, for its whole life.
#pragma once

#include <optional>

#include "render/coloring.h"
#include "render/image.h"
#include "render/occlusion.h"
#include "render/painter.h"
#include "render/small_spheres.h"

namespace ballpit {

/// A framebuffer to draw a picture into, with textures for colour and depth.
struct RenderTarget {
  /// Throws UserError if the device cannot draw pictures of that size.
  RenderTarget(int its_width, int its_height);

  void bind() const;  ///< directs drawing to the whole picture

  int width, height;  ///< [pixel]
  GlTexture color, depth;
  GlFramebuffer framebuffer;
};

struct RenderOptions {
  Theme theme = themes().front();
  int supersample = 1;   ///< 1 to 4: draws that many times larger in each direction and averages, for stills
  int left = 0;          ///< [pixel] of the picture's width that are left to a panel
  float text_scale = 1;  ///< of the scene's text
  Room beside{};         ///< parts of the picture beside the panel that are left to other views

  /// Where the view is drawn in a picture of this size [pixel].
  PictureRect part_of(int width, int height) const;
};

class Renderer {
 public:
  /// Throws UserError for sizes that no picture has or that the device cannot draw.
  Renderer(int width, int height, const RenderOptions& options = {});

  /// Draws into the part of the picture that the options give to the view; the rest stays as it is beside other views.
  /// Leaves the finished picture's framebuffer bound and its viewport set, so that a panel can draw over it.
  /// Throws RunError with OpenGL's message if drawing failed.
  void draw(const FrameView& view);

  /// The picture as drawn so far, rows from top to bottom.
  Image read_pixels();

  /// Copies the picture to the window's framebuffer.
  void copy_to_window();

  int width() const { return picture_.width; }
  int height() const { return picture_.height; }

  BodyBuffer& bodies() { return bodies_; }  ///< what is drawn, for a world that writes its bodies
  Sheet& sheet() { return sheet_; }         ///< where text is drawn; a panel shares it

  /// What notes and legend cover in the picture that was drawn last.
  const std::vector<PixelRect>& covered() const { return covered_; }

  /// Changes style or size; what is shown stays the same.
  void set_options(const RenderOptions& options);
  void resize(int width, int height);

 private:
  const RenderTarget& canvas() const { return large_ ? *large_ : picture_; }
  void set_state();
  void limit_to(const PictureRect& part, int scale);
  void draw_scene(const FrameView& view, const ColoringEntry& coloring, const Colored& colored);
  void average();

  RenderOptions options_;
  RenderTarget picture_;
  std::optional<RenderTarget> large_;  // where supersampled pictures are drawn
  Sheet sheet_;
  BodyBuffer bodies_;
  GlBuffer uniforms_;  // what all shaders share: light, camera, colours (shaders/frame/frame.glsl)
  BodyRenderer body_renderer_;
  std::optional<SmallSphereRenderer> small_;    // once it is needed
  std::optional<OcclusionRenderer> occlusion_;  // once it is needed
  LineRenderer lines_;
  FaceRenderer faces_;
  Shader average_{"average.vert", "average.frag"};
  GlVertexArray no_attributes_;
  std::vector<PixelRect> covered_;
};

}  // namespace ballpit
