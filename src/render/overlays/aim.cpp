// SPDX-License-Identifier: MIT
// Draws what the mouse is about to do: a ring around each sphere that will move, and an arrow with its new velocity.
//
//     ◯ ──────▶ 3.2 m/s
#include "core/numbers.h"
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
  const float way = length(to - from);
  if (way > 0) {  // the rim of the head is an arrow that reaches a little further
    const Vec2 along = (to - from) / way;
    painter.sheet.line(from, to - 2 * kWidth * u * along, rim, (kWidth + 2 * kRim) * u);
    painter.sheet.arrow(from, to + 2.2f * kRim * u * along, rim, (kWidth + kRim) * u);
    painter.sheet.arrow(from, to, color, kWidth * u);
  }
  const std::string speed = local_number(three_digits(aim.speed)) + " m/s";
  const std::string text = aim.is_fastest ? phrase("{}, the fastest that a step allows", speed) : speed;
  const bool is_right = to.x >= from.x;
  const Vec2 size = painter.sheet.size_of(text), at = to + Vec2((is_right ? kGap : -kGap - size.x / u) * u, 0);
  const Vec2 margin(0.4f * kGap * u, 0);
  painter.sheet.box(at - margin - Vec2(0, size.y / 2), at + margin + size * Vec2(1, 0.5f), painter.ground(), kGap * u);
  painter.sheet.text(at, kLeft, painter.ink(), text);
}

}  // namespace ballpit
