// SPDX-License-Identifier: MIT
// Draws many spheres of few pixels, each as a point, which costs a software renderer half of a quad: one vertex, and
// the depth test before the shader.
//
//     depth      of a whole sphere: that of its centre, nearer by the largest radius. Spheres that do not overlap are
//                in the right order, except for slivers near their outlines at the picture's edges; those that overlap lie
//                before each other like discs
//     shading    that of quads, but with parallel rays to a sphere
//     outlines   a second pass, farthest first, so that each is blended with what is behind it
#pragma once

#include "render/body_buffer.h"
#include "render/seen_spheres.h"

namespace ballpit {

class SmallSphereRenderer {
 public:
  /// `leaves_out_hidden`: reads the spheres back and draws only those that are seen, which changes no pixel and pays
  /// where OpenGL draws in software.
  explicit SmallSphereRenderer(bool leaves_out_hidden);

  /// Whether they are many, and so small in a picture of this height [pixel].
  static bool suits(const BodyBuffer& bodies, const FrameView& view, int height);

  /// With their shadows on the floor. The viewport is the view's part of the picture.
  void draw(const BodyBuffer& bodies, const FrameView& view);

 private:
  void draw_shadows(const std::vector<Vec4>& spheres);

  bool leaves_out_hidden_;
  Shader sphere_{"small.vert", "small.frag"}, outline_{"small.vert", "small_outline.frag"};
  Shader shadow_{"shadow.vert", "shadow.frag"};
  GlBuffer elements_, shadows_;
  GlVertexArray shadow_array_;
};

}  // namespace ballpit
