// SPDX-License-Identifier: MIT
// Draws an arrow along each velocity, from the centre of the sphere. The arrow of the fastest sphere is a twelfth of
// the picture's height, and a note gives its speed. If all spheres are slow, arrows are shorter; spheres that hardly
// move, such as those of a heap at rest, have none.
#include <cmath>

#include <fmt/format.h>

#include "core/phrase.h"
#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

constexpr float kLongest = 1.0f / 12;                        // of the picture's height, at the middle of the domain
constexpr float kArrowWidth = 4, kArrowRim = 2, kBarb = 18;  // [1/1080 of the picture's height]
constexpr float kSlow = 0.05f, kRest = 1e-3f;  // of the scene's typical speed: below them arrows are short, or absent

float fastest(const BodySnapshot& bodies) {
  float most = 0;
  if (bodies.velocity.empty()) return most;
  for (int64_t i = 0; i < bodies.count; ++i) most = std::max(most, length(bodies.velocity_of(i)));
  return most;
}

/// Adds a shaft and two barbs, in the plane that faces the viewer.
void add_arrow(const Vec3& from, const Vec3& way, float barb, const Camera& camera, Rgba color,
               std::vector<Line>& lines) {
  const Vec3 tip = from + way, along = normalize(way);
  const Vec3 look = camera.is_orthographic() ? camera.target - camera.eye : tip - camera.eye;
  const Vec3 sideways = glm::cross(along, look);
  lines.push_back({from, color, tip, color});
  if (length(sideways) < 1e-6f * length(look)) return;  // it moves straight at the viewer
  const Vec3 across = 0.5f * normalize(sideways);
  const float size = std::min(barb, 0.5f * length(way));
  for (const float side : {-1.0f, 1.0f}) lines.push_back({tip, color, tip - size * (along + side * across), color});
}

}  // namespace

float arrow_time(const FrameView& view) {
  const float speed = fastest(view.inspection.bodies);
  if (!(speed > kRest * view.typical_speed) || !std::isfinite(speed)) return 0;
  const float distance = length((view.domain.min + view.domain.max) / 2.0f - view.camera.eye);
  return kLongest * view.camera.pixel_size(distance, 1) / std::max(speed, kSlow * view.typical_speed);
}

void draw_velocities(const FrameView& view, Painter& painter) {
  const float time = arrow_time(view);
  if (time == 0) {
    painter.note("Velocities: all spheres are at rest");
    return;
  }
  const BodySnapshot& bodies = view.inspection.bodies;
  const Projection projection(view.camera, painter.sheet);
  const float scale = line_scale(view, projection, painter.sheet.unit());
  const float rest = time * kRest * view.typical_speed;
  std::vector<Line> lines;
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 centre = bodies.position_of(i), way = time * bodies.velocity_of(i);
    const float pixel = view.camera.pixel_size(projection.depth(centre), painter.sheet.height());
    if (!projection.sees(centre) || length(way) < pixel || length(way) <= rest) continue;
    const Vec3 from = projection.lift(centre, 1.02f * bodies.radius_of(i));
    add_arrow(from, way, scale * kBarb * painter.sheet.unit() * pixel, view.camera, painter.ink(), lines);
  }
  painter.draw_rimmed(lines, painter.theme.background, scale * kArrowWidth, scale * kArrowRim);
  painter.note({{Swatch::arrow, painter.theme.text,
                 phrase("longest arrow: {} m/s", local_number(fmt::format("{:.3g}", fastest(bodies))))}});
}

}  // namespace ballpit
