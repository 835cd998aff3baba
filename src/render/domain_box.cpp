// SPDX-License-Identifier: MIT
#include "render/domain_box.h"

namespace ballpit {

namespace {

constexpr float kWidth = 4.0f;  // of edges [1/1080 of the picture's height]
constexpr float kOpacity = 0.6f;
constexpr float kRise = 0.1f;  // of the box's height: by how much upright edges of an open box are longer

void add_rectangle(std::vector<Line>& lines, Vec3 corner, Vec3 u, Vec3 v, Rgba color) {
  lines.push_back({corner, color, corner + u, color});
  lines.push_back({corner + u, color, corner + u + v, color});
  lines.push_back({corner + u + v, color, corner + v, color});
  lines.push_back({corner + v, color, corner, color});
}

/// An upright edge; it fades above the top of an open box.
void add_upright(std::vector<Line>& lines, Vec3 foot, float height, bool open, const Theme& theme) {
  const Rgba color = to_rgba(theme.domain, kOpacity);
  const Vec3 top = foot + Vec3(0, height, 0);
  lines.push_back({foot, color, top, color});
  if (open) lines.push_back({top, color, top + Vec3(0, kRise * height, 0), to_rgba(theme.domain, 0.0f)});
}

}  // namespace

void draw_floor(const DomainBox& domain, Painter& painter) {
  if (domain.is_planar()) return;
  const Vec3 size = domain.max - domain.min;
  painter.faces.draw({{domain.min, {size.x, 0, 0}, {0, 0, size.z}, to_rgba(painter.theme.floor)}});
}

void draw_edges(const DomainBox& domain, Painter& painter) {
  const Vec3 size = domain.max - domain.min;
  const Vec3 x(size.x, 0, 0);
  const Vec3 z(0, 0, size.z);
  const Rgba color = to_rgba(painter.theme.domain, kOpacity);
  std::vector<Line> lines;
  if (domain.is_planar()) {
    lines.push_back({domain.min, color, domain.min + x, color});
    if (!domain.open_top) lines.push_back({domain.max - x, color, domain.max, color});
    for (const Vec3& foot : {domain.min, domain.min + x}) {
      add_upright(lines, foot, size.y, domain.open_top, painter.theme);
    }
  } else {
    add_rectangle(lines, domain.min, x, z, color);
    if (!domain.open_top) add_rectangle(lines, domain.min + Vec3(0, size.y, 0), x, z, color);
    for (const Vec3& foot : {domain.min, domain.min + x, domain.min + z, domain.min + x + z}) {
      add_upright(lines, foot, size.y, domain.open_top, painter.theme);
    }
  }
  painter.lines.draw(lines, kWidth * painter.line_unit);
}

}  // namespace ballpit
