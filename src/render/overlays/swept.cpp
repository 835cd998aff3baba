// SPDX-License-Identifier: MIT
// Draws the path of each sphere until the next search for contacts: the space that it sweeps over, and where it arrives.
//
//       ╭────────────────────╮
//     ( o )· · · · · · · · ·( )     two sides, tinted between them, and a ring at the end
//       ╰────────────────────╯
//
// Paths are the subject, so they shine through spheres that hide them. A search finds contacts at both ends of the
// path; only swept contacts are found in between. The velocity is the present one: forces during the step are ignored.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/phrase.h"
#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

constexpr float kPathWidth = 3, kPathRim = 2;  // [1/1080 of the picture's height]
constexpr float kPathTint = 0.14f;
constexpr float kSmallest = 2;  // [pixel] spheres with a smaller radius are drawn as a line

/// The shapes of all paths.
struct Paths {
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

void add_path(const Vec3& from, const Vec3& way, float radius, float radius_in_pixels, const Camera& camera,
              const Painter& painter, Paths& paths) {
  const Rgba ink = painter.ink();
  const Vec3 to = from + way, look = normalize(camera.is_orthographic() ? camera.target - camera.eye : to - camera.eye);
  const Vec3 across = glm::cross(way, look);
  if (radius_in_pixels < kSmallest) {
    paths.lines.push_back({from, ink, to, ink});
    return;
  }
  const Vec3 right = radius * normalize(glm::cross(look, camera.up)), up = glm::cross(right, look);
  add_ring(to, right, up, std::clamp(static_cast<int>(2 * radius_in_pixels), 12, 48), ink, paths.lines);
  if (length(across) < 1e-3f * length(way)) return;  // it moves straight at the viewer
  const Vec3 side = radius * normalize(across);
  for (const Vec3& s : {side, -side}) paths.lines.push_back({from + s, ink, to + s, ink});
  paths.faces.push_back({from - side, way, 2.0f * side, painter.ink(kPathTint)});
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

void draw_swept(const FrameView& view, Painter& painter) {
  const float longest = longest_way(view);
  if (!(longest > 0) || !std::isfinite(longest)) {
    painter.note("Swept ways: all spheres are at rest");
    return;
  }
  const BodySnapshot& bodies = view.inspection.bodies;
  const Projection projection(view.camera, painter.sheet);
  Paths paths;
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 centre = bodies.position_of(i), way = view.step * bodies.velocity_of(i);
    if (!projection.sees(centre) || !projection.sees(centre + way)) continue;
    if (projection.length_at(centre, length(way)) < 1) continue;
    const float radius = bodies.radius_of(i);
    add_path(centre, way, radius, projection.length_at(centre, radius), view.camera, painter, paths);
  }
  painter.faces.draw(paths.faces);
  glDisable(GL_DEPTH_TEST);
  painter.draw_rimmed(paths.lines, painter.theme.background, kPathWidth, kPathRim);
  glEnable(GL_DEPTH_TEST);
  painter.note({{Swatch::line, painter.theme.text,
                 phrase("longest way in a step: {} diameters", local_number(fmt::format("{:.3g}", longest)))}});
}

}  // namespace ballpit
