// SPDX-License-Identifier: MIT
// Bodies as solid spheres without a triangle mesh: one quad each, in whose pixels the eye's ray meets the
// sphere exactly, with exact depth. A second pass blends the outlines' pixels by how much they are covered,
// in any order. Cost: proportional to covered pixels, twice for outlines. Source: Sigg et al. 2006,
// "GPU-Based Ray-Casting of Quadratic Surfaces", doi 10.2312/SPBG/SPBG06/059-065. Sibling: disc_renderer.h
// for planar scenes.
#pragma once

#include "render/body_buffer.h"
#include "render/frame_view.h"
#include "render/shader.h"

namespace ballpit {

class SphereRenderer {
 public:
  SphereRenderer();

  /// Shadows on the floor; before the bodies.
  void draw_shadows(const BodyBuffer& bodies);

  /// `height`: of the picture, in pixels.
  void draw(const BodyBuffer& bodies, const FrameView& view, int height);

 private:
  Shader sphere_;
  Shader outline_;
  Shader point_;
  Shader shadow_;
};

/// Whether every sphere in the domain is smaller than a pixel and a half, so that points show as much.
bool all_are_points(const BodyBuffer& bodies, const FrameView& view, int height);

}  // namespace ballpit
