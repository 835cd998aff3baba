// SPDX-License-Identifier: MIT
// Marks the selected sphere with a ring, and the block of 3 × 3 (× 3) cells that is searched for its contacts (slide 10).
#include <algorithm>
#include <cmath>

#include "bodies/body_snapshot.h"
#include "broad_phase/inspection.h"
#include "render/overlays/overlay.h"
#include "render/painter.h"
#include "render/projection.h"

namespace ballpit {

namespace {

constexpr float kTint = 0.2f;
constexpr float kWidth = 5;  // [1/1080 of the picture's height]

/// The sides of the block behind the spheres in it, as the viewer sees them.
std::vector<Face> far_sides(const Vec3& low, const Vec3& size, const Camera& camera, Rgba color) {
  std::vector<Face> faces;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 corner = low, u(0), v(0);
    const bool from_above = camera.eye[axis] > low[axis] + size[axis] / 2;
    if (!from_above) corner[axis] += size[axis];
    u[(axis + 1) % 3] = size[(axis + 1) % 3];
    v[(axis + 2) % 3] = size[(axis + 2) % 3];
    faces.push_back({corner, u, v, color});
  }
  return faces;
}

std::vector<Line> edges_of(const Vec3& low, const Vec3& size, Rgba color) {
  std::vector<Line> lines;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 from = low, along(0);
      if (corner & 1) from[a] += size[a];
      if (corner & 2) from[b] += size[b];
      along[axis] = size[axis];
      if (length(along) > 0) lines.push_back({from, color, from + along, color});
    }
  }
  return lines;
}

void draw_block(const GridInspection& grid, const Block& block, const FrameView& view, Painter& painter) {
  const DomainBox& domain = view.domain;
  const Vec3 low = grid.origin + grid.edge * Vec3(block.low);
  Vec3 high = grid.origin + grid.edge * Vec3(block.high);
  for (int axis = 0; axis < 3; ++axis) {  // the last cells may extend beyond the wall
    if (block.high[axis] == grid.cells[axis] && !(axis == 1 && domain.open_top)) high[axis] = domain.max[axis];
  }
  Vec3 size = high - low;
  const Rgba tint = to_rgba(painter.theme.selected, kTint);
  if (domain.is_planar()) {
    size.z = 0;
    painter.faces.draw({{low, {size.x, 0, 0}, {0, size.y, 0}, tint}});
  } else {
    painter.faces.draw(far_sides(low, size, view.camera, tint));
  }
  painter.lines.draw(edges_of(low, size, to_rgba(painter.theme.selected)), kWidth * painter.line_unit);
}

}  // namespace

std::optional<Block> block_around(const GridInspection& grid, const BodySnapshot& bodies, int64_t body) {
  const Vec3 place = (bodies.position_of(body) - grid.origin) / grid.edge;
  IVec3 cell;
  for (int axis = 0; axis < 3; ++axis) {
    const int inside = std::isfinite(place[axis]) ? static_cast<int>(std::floor(place[axis])) : 0;
    cell[axis] = std::clamp(inside, 0, grid.cells[axis] - 1);
  }
  if (grid.head.empty()) return std::nullopt;
  const auto index = static_cast<size_t>((cell.z * grid.cells.y + cell.y) * grid.cells.x + cell.x);
  if (index >= grid.head.size()) return std::nullopt;
  int32_t listed = grid.head[index];
  while (listed >= 0 && listed != body) listed = grid.next[static_cast<size_t>(listed)];
  if (listed < 0) return std::nullopt;
  return Block{glm::max(cell - 1, IVec3(0)), glm::min(cell + 2, grid.cells)};
}

void draw_selection(const FrameView& view, Painter& painter) {
  const BodySnapshot& bodies = view.inspection.bodies;
  if (view.selected < 0 || view.selected >= bodies.count) return;
  for (const GridInspection& grid : view.inspection.grids) {
    const std::optional<Block> block = block_around(grid, bodies, view.selected);
    if (block) draw_block(grid, *block, view, painter);
  }
  const Projection projection(view.camera, painter.sheet);
  const Vec3 centre = bodies.position_of(view.selected);
  if (!projection.sees(centre)) return;
  const float u = painter.sheet.unit(), radius = projection.length_at(centre, bodies.radius_of(view.selected));
  painter.sheet.ring(projection.at(centre), radius + 4 * u, to_rgba(painter.theme.selected), 8 * u);
}

}  // namespace ballpit
