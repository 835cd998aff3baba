// SPDX-License-Identifier: MIT
#include "render/occlusion.h"

#include <algorithm>
#include <cmath>

namespace ballpit {

namespace {

constexpr float kPerRadius = 2.5f;           // pixels of the floor map: shadows are soft
constexpr int kFewest = 128, kMost = 768;    // of its longer side [pixel]
constexpr int64_t kCrowd = 500;              // spheres
constexpr float kAnywhere = 1e6f, kLow = 6;  // [radius] height up to which spheres have a shadow: in a crowd, those of
                                             // higher ones would make the whole floor dark

}  // namespace

OcclusionRenderer::Map::Map(int its_width, int its_height) : width(its_width), height(its_height) {
  glTextureStorage2D(left.name(), 1, GL_RG8, width, height);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTextureParameteri(left.name(), axis, GL_CLAMP_TO_EDGE);
  }
  glTextureParameteri(left.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glNamedFramebufferTexture(framebuffer.name(), GL_COLOR_ATTACHMENT0, left.name(), 0);
}

void OcclusionRenderer::make_floor_map(const BodyBuffer& bodies, const DomainBox& domain) {
  const Vec3 size = domain.max - domain.min;
  const float longest = std::max(size.x, size.z);
  const float side = std::clamp(kPerRadius * longest / bodies.max_radius(), float(kFewest), float(kMost));
  const auto pixels = [&](float edge) { return std::max(1, static_cast<int>(std::lround(side * edge / longest))); };
  if (!map_ || map_->width != pixels(size.x) || map_->height != pixels(size.z)) {
    map_.emplace(pixels(size.x), pixels(size.z));
  }
  glBindFramebuffer(GL_FRAMEBUFFER, map_->framebuffer.name());
  glViewport(0, 0, map_->width, map_->height);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  floor_map_.set("highest", bodies.count() <= kCrowd ? kAnywhere : kLow);
  draw_quads(floor_map_, bodies, false);
}

void OcclusionRenderer::draw_floor() const {
  floor_.use();
  glBindTextureUnit(1, map_->left.name());
  glBindVertexArray(no_attributes_.name());
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
}

void OcclusionRenderer::draw_bodies(const BodyBuffer& bodies, const GlTexture& depth) const {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_quads(depth_, bodies, true);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glTextureBarrier();  // what follows reads the depth that it is tested against, and writes none
  glBindTextureUnit(0, depth.name());
  draw_quads(sphere_, bodies, false);
  draw_quads(outline_, bodies, false);
}

}  // namespace ballpit
