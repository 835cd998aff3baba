// SPDX-License-Identifier: MIT
// Writes the number of each sphere at its centre, if the sphere is large enough and not hidden. In planar scenes with few
// cells also the number of each cell: in its lower left corner (slide 8), or in another one if a sphere lies there.
#include <iterator>

#include "render/body_buffer.h"
#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

constexpr float kMinRadius = 7;       // [pixel] of a sphere
constexpr size_t kMaxSpheres = 3000;  // of more spheres, the nearest get numbers
constexpr size_t kMaxCells = 400;

struct Seen {
  int64_t body;
  Vec2 at;
  float radius, depth;
};

/// Spheres large enough for a number, from near to far.
std::vector<Seen> large_spheres(const FrameView& view, const Projection& projection, const Sheet& sheet) {
  const BodySnapshot& bodies = view.inspection.bodies;
  std::vector<Seen> seen;
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 centre = bodies.position_of(i);
    if (!projection.sees(centre)) continue;
    const float radius = projection.length_at(centre, bodies.radius_of(i));
    const Vec2 at = projection.at(centre);
    const bool is_outside =
        at.x < 0 || at.y < 0 || at.x > static_cast<float>(sheet.width()) || at.y > static_cast<float>(sheet.height());
    if (radius >= kMinRadius && !is_outside) seen.push_back({i, at, radius, projection.depth(centre)});
  }
  std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.depth < b.depth; });
  if (seen.size() > kMaxSpheres) seen.resize(kMaxSpheres);
  return seen;
}

/// The largest size in which a number fits into its sphere.
std::optional<TextSize> size_within(const std::string& text, float radius, const Sheet& sheet) {
  for (const TextSize size : {TextSize::normal, TextSize::small}) {
    const Vec2 extent = sheet.size_of(text, size);
    if (extent.x <= 1.7f * radius && extent.y <= 2 * radius) return size;
  }
  if (sheet.size_of(text, TextSize::small).x <= 2.2f * radius) return TextSize::small;
  return std::nullopt;
}

struct Area {
  Vec2 low, high;
};

bool meets(const Area& area, const Seen& sphere) {
  return length(glm::clamp(sphere.at, area.low, area.high) - sphere.at) < sphere.radius;
}

bool meets(const Area& a, const Area& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// From near to far: a sphere gets no number where a nearer sphere or number covers it. Where lines meet in the centre, a
/// number has a disc of its sphere's colour behind it. Returns how many numbers were drawn.
size_t draw_numbers(const FrameView& view, const std::vector<Seen>& spheres, Painter& painter) {
  const std::vector<Mark> marks = contact_marks(view.inspection.bodies.count, view.inspection.contacts);
  const bool has_discs = view.shows("pairs") || view.shows("velocity") || view.shows("intervals");
  std::vector<Area> taken;
  for (size_t k = 0; k < spheres.size(); ++k) {
    const Seen& sphere = spheres[k];
    const std::string text = std::to_string(sphere.body);
    const std::optional<TextSize> size = size_within(text, sphere.radius, painter.sheet);
    if (!size) continue;
    const Vec2 half = 0.4f * painter.sheet.size_of(text, *size);
    const Area area{sphere.at - half, sphere.at + half};
    const auto end = spheres.begin() + static_cast<std::ptrdiff_t>(view.domain.is_planar() ? 0 : k);
    if (std::any_of(spheres.begin(), end, [&](const Seen& nearer) { return meets(area, nearer); })) continue;
    if (std::any_of(taken.begin(), taken.end(), [&](const Area& other) { return meets(area, other); })) continue;
    taken.push_back(area);
    if (has_discs) {
      const bool touches = marks[static_cast<size_t>(sphere.body)] == Mark::contact;
      const Rgba color = to_rgba(touches ? painter.theme.contact : painter.theme.body, 0.85f);
      painter.sheet.disc(sphere.at, std::min(1.2f * length(half), 0.9f * sphere.radius), color);
    }
    painter.sheet.text(sphere.at, kCentre, to_rgba(painter.theme.on_body), text, *size);
  }
  return taken.size();
}

/// In the cell's lower left corner, as on the slide; if a sphere lies there, in the first free corner, if any.
void draw_cell_number(size_t cell, const Area& square, const std::vector<Seen>& spheres, Painter& painter) {
  constexpr Anchor kCorners[] = {kLowerLeft, {1, 1}, kUpperLeft, kUpperRight};
  Sheet& sheet = painter.sheet;
  const std::string text = std::to_string(cell);
  const Vec2 inset = Vec2(6, 3) * sheet.unit(), size = sheet.size_of(text, TextSize::small);
  const auto place = [&](const Anchor& anchor) {
    const Vec2 part(anchor.x, anchor.y), low = square.low + inset, room = square.high - inset - low - size;
    return Area{low + part * room, low + part * room + size};
  };
  const auto is_free = [&](const Anchor& anchor) {
    return std::none_of(spheres.begin(), spheres.end(),
                        [&](const Seen& sphere) { return meets(place(anchor), sphere); });
  };
  const Anchor* corner = std::find_if(std::begin(kCorners), std::end(kCorners), is_free);
  if (corner == std::end(kCorners)) return;
  const Area area = place(*corner);
  sheet.text(area.low, kUpperLeft, to_rgba(painter.theme.grid), text, TextSize::small);
}

void draw_cell_numbers(const GridInspection& grid, const DomainBox& domain, const std::vector<Seen>& spheres,
                       const Projection& projection, Painter& painter) {
  const Vec2 widest = painter.sheet.size_of(std::to_string(grid.head.size() - 1), TextSize::small);
  if (projection.length_at(grid.origin, std::min(grid.edge.x, grid.edge.y)) < widest.x + widest.y) return;
  const auto columns = static_cast<size_t>(grid.cells.x);
  for (size_t cell = 0; cell < grid.head.size(); ++cell) {
    const Vec3 low = grid.origin + grid.edge * Vec3(cell % columns, cell / columns, 0);
    const Vec3 high = glm::min(low + Vec3(grid.edge.x, grid.edge.y, 0), glm::max(domain.max, low));
    const Vec2 a = projection.at(low), b = projection.at(high);
    draw_cell_number(cell, {{a.x, b.y}, {b.x, a.y}}, spheres, painter);
  }
}

}  // namespace

void draw_labels(const FrameView& view, Painter& painter) {
  const Projection projection(view.camera, painter.sheet);
  const std::vector<Seen> spheres = large_spheres(view, projection, painter.sheet);
  const std::vector<GridInspection>& grids = view.inspection.grids;
  if (view.domain.is_planar() && grids.size() == 1 && grids[0].head.size() <= kMaxCells && !grids[0].head.empty()) {
    draw_cell_numbers(grids[0], view.domain, spheres, projection, painter);
  }
  if (draw_numbers(view, spheres, painter) == 0 && view.inspection.bodies.count > 0) {
    painter.note("no numbers: the spheres are too small in the picture");
  }
}

}  // namespace ballpit
