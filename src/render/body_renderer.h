// SPDX-License-Identifier: MIT
// Draws bodies without a triangle mesh. Spatial scenes: one quad for each sphere, in whose pixels the eye's ray meets the
// sphere exactly, with exact depth. A second pass blends the pixels of the outline by how much the sphere covers them, in
// any order. Planar scenes: flat discs with an outline; later bodies lie over earlier ones.
// Cost: proportional to the covered pixels, twice for outlines.
// Source: Sigg et al. 2006, "GPU-Based Ray-Casting of Quadratic Surfaces", doi 10.2312/SPBG/SPBG06/059-065.
#pragma once

#include "render/body_buffer.h"
#include "render/frame_view.h"
#include "render/shader.h"

namespace ballpit {

class BodyRenderer {
 public:
  /// `height` of the picture [pixel].
  void draw(const BodyBuffer& bodies, const FrameView& view, int height);

 private:
  Shader disc_{"disc.vert", "disc.frag"};
  Shader sphere_{"sphere.vert", "sphere.frag"};
  Shader outline_{"outline.vert", "outline.frag"};
  Shader point_{"point.vert", "point.frag"};
  Shader shadow_{"shadow.vert", "shadow.frag"};  // of spheres on the floor
};

}  // namespace ballpit
