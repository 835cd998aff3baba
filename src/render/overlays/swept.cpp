// SPDX-License-Identifier: MIT
#include "render/overlays/swept.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "bodies/body_snapshot.h"
#include "render/painter.h"
#include "render/projection.h"

namespace ballpit {

namespace {

constexpr float kWidth = 3;  // [1/1080 of the picture's height]
constexpr float kOpacity = 0.85f, kTint = 0.14f;
constexpr float kSmallest = 2;  // [pixel] a smaller radius is a line without sides and ring

/// What is drawn of all ways.
struct Ways {
  std::vector<Line> lines;
  std::vector<Face> faces;
};

/// A circle that faces the viewer, spanned by two vectors as long as its radius.
void add_ring(const Vec3& centre, const Vec3& a, const Vec3& b, int corners, Rgba color, std::vector<Line>& lines) {
  Vec3 last = centre + a;
  for (int k = 1; k <= corners; ++k) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(corners);
    const Vec3 next = centre + std::cos(angle) * a + std::sin(angle) * b;
    lines.push_back({last, color, next, color});
    last = next;
  }
}

void add_way(const Vec3& from, const Vec3& way, float radius, float radius_in_pixels, const Camera& camera,
             const Painter& painter, Ways& ways) {
  const Rgba ink = painter.ink(kOpacity);
  const Vec3 to = from + way, look = normalize(camera.is_orthographic() ? camera.target - camera.eye : to - camera.eye);
  const Vec3 across = glm::cross(way, look);
  if (radius_in_pixels < kSmallest) {
    ways.lines.push_back({from, ink, to, ink});
    return;
  }
  const Vec3 right = radius * normalize(glm::cross(look, camera.up)), up = glm::cross(right, look);
  add_ring(to, right, up, std::clamp(static_cast<int>(2 * radius_in_pixels), 12, 48), ink, ways.lines);
  if (length(across) < 1e-3f * length(way)) return;  // it flies at the viewer
  const Vec3 side = radius * normalize(across);
  for (const Vec3& s : {side, -side}) ways.lines.push_back({from + s, ink, to + s, ink});
  ways.faces.push_back({from - side, way, 2.0f * side, painter.ink(kTint)});
}

}  // namespace

float longest_way(const FrameView& view) {
  const BodySnapshot& bodies = view.inspection.bodies;
  float most = 0;
  if (bodies.velocity.empty()) return most;
  for (int64_t i = 0; i < bodies.count; ++i) {
    most = std::max(most, length(bodies.velocity_of(i)) * view.step / (2 * bodies.radius_of(i)));
  }
  return most;
}

void SweptOverlay::draw(const FrameView& view, Painter& painter, Layer layer) {
  if (layer != Layer::over) return;
  const float longest = longest_way(view);
  if (!(longest > 0) || !std::isfinite(longest)) {
    painter.note({{Swatch::none, {}, "no swept ways: all spheres are at rest"}});
    return;
  }
  const BodySnapshot& bodies = view.inspection.bodies;
  const Projection projection(view.camera, painter.sheet);
  Ways ways;
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 centre = bodies.position_of(i), way = view.step * bodies.velocity_of(i);
    if (!projection.sees(centre) || !projection.sees(centre + way)) continue;
    if (projection.length_at(centre, length(way)) < 1) continue;
    const float radius = bodies.radius_of(i);
    add_way(centre, way, radius, projection.length_at(centre, radius), view.camera, painter, ways);
  }
  painter.faces.draw(ways.faces);
  painter.lines.draw(ways.lines, kWidth * painter.line_unit);
  char text[64];
  std::snprintf(text, sizeof(text), "longest way in a step: %.3g diameters", static_cast<double>(longest));
  painter.note({{Swatch::line, painter.theme.text, text}});
}

}  // namespace ballpit
