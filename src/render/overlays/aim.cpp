// SPDX-License-Identifier: MIT
// Draws what the mouse is about to do: a ring around each sphere that will move, and an arrow with its new velocity.
//
//     ◯ ──────▶ 3.2 m/s
#include "core/phrase.h"
#include "render/overlays/overlay.h"

namespace ballpit {

void draw_aim(const FrameView& view, Painter& painter) {
  if (!view.aim) return;
  constexpr float kWidth = 7, kRim = 2, kRing = 5, kGap = 14;  // [1/1080 of the picture's height]
  const Aim& aim = *view.aim;
  const Projection projection(view.camera, painter.sheet);
  const float u = painter.sheet.unit();
  const Rgba color = to_rgba(painter.theme.selected), rim = to_rgba(rim_of(painter.theme.selected));
  for (const Aim::Ring& ring : aim.rings) {
    if (!projection.sees(ring.centre)) continue;
    const float radius = projection.length_at(ring.centre, ring.radius) + kRing / 2 * u;
    painter.sheet.ring(projection.at(ring.centre), radius, rim, (kRing + 2 * kRim) * u);
    painter.sheet.ring(projection.at(ring.centre), radius, color, kRing * u);
  }
  if (!projection.sees(aim.from) || !projection.sees(aim.to)) return;
  const Vec2 from = projection.at(aim.from), to = projection.at(aim.to);
  painter.sheet.arrow(from, to, rim, (kWidth + 2 * kRim) * u);
  painter.sheet.arrow(from, to, color, kWidth * u);
  const std::string speed = local_number(fmt::format("{:.2g}", aim.speed)) + " m/s";
  const bool is_right = to.x >= from.x;
  painter.sheet.bordered_text(
      to + Vec2((is_right ? kGap : -kGap) * u, 0), is_right ? kLeft : Anchor{1, 0.5f}, painter.ink(), painter.ground(),
      aim.is_fastest ? phrase("{}, the fastest that a step allows", speed) : speed, TextSize::normal);
}

}  // namespace ballpit
