// SPDX-License-Identifier: MIT
#include "render/frame_uniforms.h"

#include "render/coloring.h"

namespace ballpit {

namespace {

/// In the layout of shaders/frame/frame.glsl (std140).
struct Block {
  Mat4 view;
  Mat4 projection;
  Vec4 key_light;
  Vec4 halfway;
  Vec4 sky;
  Vec4 units;
  Vec4 shadow;
  Vec4 background;
  Vec4 mark_color[2 + kScaleColors];
  Vec2 viewport;
  float pixel;
  float line_unit;
};

}  // namespace

FrameUniforms::FrameUniforms() { glNamedBufferStorage(buffer_.name(), sizeof(Block), nullptr, GL_DYNAMIC_STORAGE_BIT); }

void FrameUniforms::set(const FrameView& view, const Theme& theme, int width, int height) {
  Block uniforms;
  const DomainBox& domain = view.domain;
  const Camera camera = in_units(view.camera, domain.min, domain.longest_edge());
  uniforms.view = camera.view();
  uniforms.projection = camera.projection();
  // The light is behind the viewer's left shoulder and moves with the camera, so the lit sides are always visible.
  const Vec3 light = normalize(Vec3(-0.5f, 0.75f, 0.75f));
  uniforms.key_light = Vec4(light, theme.key);
  uniforms.halfway = Vec4(normalize(light + Vec3(0, 0, 1)), 0);
  uniforms.sky = Vec4(Vec3(uniforms.view * Vec4(0, 1, 0, 0)), theme.ambient);
  uniforms.units = Vec4(domain.min, 1 / domain.longest_edge());
  uniforms.shadow = Vec4(theme.shadow, 0, 0, 0);
  uniforms.background = Vec4(theme.background, 1);
  for (int mark = 0; mark < 2 + kScaleColors; ++mark) uniforms.mark_color[mark] = Vec4(color_of(theme, mark), 1);
  uniforms.viewport = Vec2(width, height);
  uniforms.pixel = camera.pixel_size(1.0f, height);
  uniforms.line_unit = static_cast<float>(height) / 1080.0f;
  glNamedBufferSubData(buffer_.name(), 0, sizeof(uniforms), &uniforms);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer_.name());
}

}  // namespace ballpit
