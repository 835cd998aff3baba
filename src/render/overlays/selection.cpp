// SPDX-License-Identifier: MIT
// Marks the selected sphere with a ring, and the block of 3 × 3 (× 3) cells that is searched for its contacts (slide 10).
// Finds its list and its partners for the panel.
#include <cmath>

#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

constexpr float kTint = 0.2f;
constexpr float kWidth = 5, kRingRim = 1.5f, kInset = 6;  // [1/1080 of the picture's height]

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

void draw_block(const GridInspection& grid, const Block& block, const FrameView& view, Painter& painter) {
  const DomainBox& domain = view.domain;
  Vec3 low = lattice_point(grid, domain, block.low);
  Vec3 size = lattice_point(grid, domain, block.high) - low;
  if (domain.is_planar()) {  // beside the border of the domain, not under it
    const float inset = kInset / 1080 * view.camera.orthographic_height;
    const Vec3 high = glm::min(low + size, domain.max - inset);
    low = glm::max(low, domain.min + inset);
    size = high - low;
  }
  const Rgba tint = to_rgba(painter.theme.selected, kTint);
  if (domain.is_planar()) {
    size.z = 0;
    painter.faces.draw({{low, {size.x, 0, 0}, {0, size.y, 0}, tint}});
  } else {
    painter.faces.draw(far_sides(low, size, view.camera, tint));
  }
  std::vector<Line> lines;
  add_box_edges(low, low + size, to_rgba(painter.theme.selected), lines);
  painter.draw_shining(lines, rim_of(painter.theme.selected), kWidth, kRingRim);
}

/// The cell that lists the body; none if the grid does not list it.
std::optional<IVec3> cell_listing(const GridInspection& grid, const BodySnapshot& bodies, int64_t body) {
  const IVec3 cell = cell_of(grid, bodies, body);
  const size_t index = index_of(grid, cell);
  if (index >= grid.head.size()) return std::nullopt;
  int32_t listed = grid.head[index];
  while (listed >= 0 && listed != body) listed = grid.next[static_cast<size_t>(listed)];
  return listed < 0 ? std::nullopt : std::optional(cell);
}

}  // namespace

void add_box_edges(const Vec3& low, const Vec3& high, Rgba color, std::vector<Line>& lines) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 from = corner_of(low, high, corner);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 to = from;
      to[axis] = high[axis];
      const bool is_flat = low.z == high.z && corner >= 4;
      if (!(corner >> axis & 1) && !is_flat && high[axis] > low[axis]) lines.push_back({from, color, to, color});
    }
  }
}

IVec3 cell_of(const GridInspection& grid, const BodySnapshot& bodies, int64_t body) {
  const Vec3 place = (bodies.position_of(body) - grid.origin) / grid.edge;
  IVec3 cell(0);
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(place[axis])) continue;
    cell[axis] = static_cast<int>(std::clamp(place[axis], 0.0f, static_cast<float>(grid.cells[axis] - 1)));
  }
  return cell;
}

std::optional<Block> block_around(const GridInspection& grid, const BodySnapshot& bodies, int64_t body) {
  const std::optional<IVec3> cell = cell_listing(grid, bodies, body);
  if (!cell) return std::nullopt;
  return Block{glm::max(*cell - 1, IVec3(0)), glm::min(*cell + 2, grid.cells)};
}

std::optional<ListedIn> listed_in(const Inspection& inspection, int32_t body) {
  for (const GridInspection& grid : inspection.grids) {
    const std::optional<IVec3> cell = cell_listing(grid, inspection.bodies, body);
    if (!cell) continue;
    const size_t index = index_of(grid, *cell);
    ListedIn found{*cell, static_cast<int>(index), grid.is_sorted()};
    for (int32_t b = grid.head[index]; b >= 0; b = grid.next[static_cast<size_t>(b)]) found.bodies.push_back(b);
    if (found.is_sorted) std::reverse(found.bodies.begin(), found.bodies.end());
    found.place = static_cast<size_t>(std::find(found.bodies.begin(), found.bodies.end(), body) - found.bodies.begin());
    return found;
  }
  return std::nullopt;
}

std::vector<int32_t> partners_of(const std::vector<Pair>& pairs, int32_t body) {
  std::vector<int32_t> partners;
  for (const Pair& pair : pairs) {
    if (pair.i == body) partners.push_back(pair.j);
    if (pair.j == body) partners.push_back(pair.i);
  }
  std::sort(partners.begin(), partners.end());
  partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
  return partners;
}

std::vector<int32_t> touching(const Inspection& inspection, int32_t body) {
  std::vector<Pair> all = inspection.contacts;
  all.insert(all.end(), inspection.missed.begin(), inspection.missed.end());
  return partners_of(all, body);
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
  painter.sheet.ring(projection.at(centre), radius + 4 * u, to_rgba(rim_of(painter.theme.selected)), 10 * u);
  painter.sheet.ring(projection.at(centre), radius + 4 * u, to_rgba(painter.theme.selected), 7 * u);
}

}  // namespace ballpit
