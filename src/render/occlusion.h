// SPDX-License-Identifier: MIT
// Draws spheres and floor with ambient occlusion and one soft shadow, from the occluders that a world has found
// (world/occluders.h).
//
//     floor map     a picture of the floor from above: what all spheres leave of the sky and of the light, multiplied
//     first pass    depth of all spheres
//     second pass   light of the surfaces that are seen: what each occluder hides in closed form, cut at the horizon
//                   (shaders/occlusion/occlusion.glsl); then the outlines
//
// The second pass costs about as much as drawing the spheres twice, but only where they are seen: where spheres lie
// behind each other, the first pass saves more than the second costs. Occluders beyond the strongest kOccluders are
// left out, and what overlaps is multiplied as if it did not; docs/decisions/0034 says how far that is from the truth.
#pragma once

#include <optional>

#include "render/body_buffer.h"

namespace ballpit {

class OcclusionRenderer {
 public:
  /// Draws the floor map into a texture of its own; binds its framebuffer and viewport.
  void make_floor_map(const BodyBuffer& bodies, const DomainBox& domain);

  /// Needs the floor map of the same state.
  void draw_floor() const;

  /// `depth`: the texture that the bound framebuffer has for depth.
  void draw_bodies(const BodyBuffer& bodies, const GlTexture& depth) const;

 private:
  struct Map {
    Map(int its_width, int its_height);

    int width, height;  // [pixel]
    GlTexture left;
    GlFramebuffer framebuffer;
  };

  Shader depth_{"sphere.vert", "depth.frag"};
  Shader sphere_{"occluded.vert", "occluded.frag"};
  Shader outline_{"occluded_outline.vert", "occluded_outline.frag"};
  Shader floor_map_{"floor_map.vert", "floor_map.frag"};
  Shader floor_{"floor.vert", "floor.frag"};
  GlVertexArray no_attributes_;
  std::optional<Map> map_;
};

}  // namespace ballpit
