// SPDX-License-Identifier: MIT
#include "render/overlays/labels.h"

#include <algorithm>
#include <optional>
#include <string>

#include "render/painter.h"
#include "render/projection.h"

namespace ballpit {

namespace {

constexpr float kSmallest = 7;         // [pixel] a sphere's radius
constexpr size_t kMostSpheres = 3000;  // larger than that: the nearest ones
constexpr size_t kMostCells = 400;

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
    if (radius >= kSmallest && !is_outside) seen.push_back({i, at, radius, projection.depth(centre)});
  }
  std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.depth < b.depth; });
  if (seen.size() > kMostSpheres) seen.resize(kMostSpheres);
  return seen;
}

/// The largest size in which a number stays within its sphere.
std::optional<TextSize> size_within(const std::string& text, float radius, const Sheet& sheet) {
  for (const TextSize size : {TextSize::normal, TextSize::small}) {
    const Vec2 extent = sheet.size_of(text, size);
    if (extent.x <= 1.7f * radius && extent.y <= 2 * radius) return size;
  }
  if (sheet.size_of(text, TextSize::small).x <= 2.2f * radius) return TextSize::small;
  return std::nullopt;
}

void draw_numbers(const std::vector<Seen>& spheres, bool is_planar, Painter& painter) {
  for (size_t k = 0; k < spheres.size(); ++k) {
    const Seen& sphere = spheres[k];
    const auto hides = [&](const Seen& nearer) { return length(nearer.at - sphere.at) < nearer.radius; };
    if (!is_planar && std::any_of(spheres.begin(), spheres.begin() + static_cast<std::ptrdiff_t>(k), hides)) continue;
    const std::string text = std::to_string(sphere.body);
    const std::optional<TextSize> size = size_within(text, sphere.radius, painter.sheet);
    if (size) painter.sheet.text(sphere.at, kCentre, to_rgba(painter.theme.on_body), text, *size);
  }
}

void draw_cell_numbers(const GridInspection& grid, const std::vector<Seen>& spheres, const Projection& projection,
                       Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  const Vec2 widest = sheet.size_of(std::to_string(grid.head.size() - 1), TextSize::small);
  if (projection.length_at(grid.origin, std::min(grid.edge.x, grid.edge.y)) < widest.x + widest.y) return;
  for (size_t cell = 0; cell < grid.head.size(); ++cell) {
    const auto columns = static_cast<size_t>(grid.cells.x);
    const Vec3 corner = grid.origin + grid.edge * Vec3(cell % columns, cell / columns, 0);
    const std::string text = std::to_string(cell);
    const Vec2 at = projection.at(corner) + Vec2(6, -3) * u, size = sheet.size_of(text, TextSize::small);
    const Vec2 low(at.x, at.y - size.y), high(at.x + size.x, at.y);
    const bool on_sphere = std::any_of(spheres.begin(), spheres.end(), [&](const Seen& sphere) {
      return length(glm::clamp(sphere.at, low, high) - sphere.at) < sphere.radius;
    });
    if (on_sphere) sheet.box(low, high, painter.ground(), 3 * u);
    sheet.text(at, kLowerLeft, to_rgba(painter.theme.grid), text, TextSize::small);
  }
}

}  // namespace

void LabelsOverlay::draw(const FrameView& view, Painter& painter, Layer layer) {
  if (layer != Layer::over) return;
  const Projection projection(view.camera, painter.sheet);
  const std::vector<Seen> spheres = large_spheres(view, projection, painter.sheet);
  const std::vector<GridInspection>& grids = view.inspection.grids;
  if (view.domain.is_planar() && grids.size() == 1 && grids[0].head.size() <= kMostCells && !grids[0].head.empty()) {
    draw_cell_numbers(grids[0], spheres, projection, painter);
  }
  draw_numbers(spheres, view.domain.is_planar(), painter);
}

}  // namespace ballpit
