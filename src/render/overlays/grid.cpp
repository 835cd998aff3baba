// SPDX-License-Identifier: MIT
// Draws the cells of a grid that hold bodies, stronger the more bodies they hold.
//
//     spatial: edges of occupied cells        planar: tinted squares, and
//     (an edge of several cells               thin lines of all cells
//     is drawn once); in a crowd                ┌──┬──┬──┐
//     only of the densest ones                  │  │▒▒│  │
//        ┌──┬──┐                                ├──┼──┼──┤
//        ├──┼──┘                                │░░│  │▓▓│
//        └──┘                                   └──┴──┴──┘
// The edges of thousands of cells would be a haze over the spheres. Cost: proportional to the number of cells and
// bodies.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "core/phrase.h"
#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

constexpr float kEdgeWidth = 2.0f, kDenseWidth = 4, kDenseRim = 2;  // [1/1080 of the picture's height]
constexpr float kThinnest = 0.5f;                                   // of kEdgeWidth, between small discs
constexpr int64_t kCrowdOfCells = 500;                              // spheres in space
constexpr size_t kDensest = 12;                                     // cells drawn in a crowd

/// 0 to 1: one body is clearly visible, and counts up to about eight look different.
float strength(int count) { return static_cast<float>(count) / static_cast<float>(count + 2); }

/// Cells with one body are faint, full cells stand out.
float spatial_opacity(int count) { return std::min(0.4f + 0.25f * static_cast<float>(count - 1), 1.0f); }

/// 1 for few cells, whose edges hide nothing: they are drawn boldly, also at the back of the box. Towards 0 for many.
float boldness(const std::vector<int>& counts) {
  constexpr float kFew = 24;
  const auto occupied = static_cast<float>(counts.size()) - static_cast<float>(std::ranges::count(counts, 0));
  return std::min(kFew / std::max(occupied, 1.0f), 1.0f);
}

/// The largest count of the cells around the lattice edge that starts at `point` and runs along `axis`.
int fullest_around_edge(const GridInspection& grid, const std::vector<int>& counts, IVec3 point, int axis) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  int fullest = 0;
  for (int da = -1; da <= 0; ++da) {
    for (int db = -1; db <= 0; ++db) {
      IVec3 cell = point;
      cell[a] += da;
      cell[b] += db;
      if (cell[a] < 0 || cell[b] < 0 || cell[a] >= grid.cells[a] || cell[b] >= grid.cells[b]) continue;
      fullest = std::max(fullest, counts[index_of(grid, cell)]);
    }
  }
  return fullest;
}

float fade_at(const Vec3& point, const GridInspection& grid, const Camera& camera) {
  return ballpit::fade_at(point, grid.origin, grid.origin + grid.edge * Vec3(grid.cells), camera);
}

/// Adds the lattice's edges along `axis` through `start`, in colours by count and place; neighbours with equal counts
/// become one line.
template <class Color>
void add_edges_along(int axis, IVec3 start, const GridInspection& grid, const std::vector<int>& counts,
                     const DomainBox& domain, Color&& color_at, std::vector<Line>& lines) {
  const auto count_at = [&](int step) {
    IVec3 point = start;
    point[axis] = step;
    return step < grid.cells[axis] ? fullest_around_edge(grid, counts, point, axis) : 0;
  };
  for (int step = 0; step < grid.cells[axis];) {
    const int count = count_at(step);
    const int first = step++;
    if (count == 0) continue;
    while (count_at(step) == count) ++step;
    IVec3 end = start;
    start[axis] = first;
    end[axis] = step;
    const Vec3 a = lattice_point(grid, domain, start), b = lattice_point(grid, domain, end);
    lines.push_back({a, color_at(count, a), b, color_at(count, b)});
  }
}

std::vector<Line> occupied_edges(const GridInspection& grid, const std::vector<int>& counts, const FrameView& view,
                                 const Theme& theme) {
  const float least = boldness(counts);
  const auto color_at = [&](int count, const Vec3& point) {
    return to_rgba(theme.grid, std::max(least, spatial_opacity(count) * fade_at(point, grid, view.camera)));
  };
  std::vector<Line> lines;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    IVec3 start(0);
    for (start[a] = 0; start[a] <= grid.cells[a]; ++start[a]) {
      for (start[b] = 0; start[b] <= grid.cells[b]; ++start[b]) {
        add_edges_along(axis, start, grid, counts, view.domain, color_at, lines);
      }
    }
  }
  return lines;
}

/// The squares of the occupied cells of a planar scene.
std::vector<Face> occupied_faces(const GridInspection& grid, const std::vector<int>& counts, const FrameView& view,
                                 const Theme& theme) {
  std::vector<Face> faces;
  IVec3 cell(0);
  for (cell.y = 0; cell.y < grid.cells.y; ++cell.y) {
    for (cell.x = 0; cell.x < grid.cells.x; ++cell.x) {
      const int count = counts[index_of(grid, cell)];
      if (count == 0) continue;
      const Vec3 low = lattice_point(grid, view.domain, cell), size = lattice_point(grid, view.domain, cell + 1) - low;
      faces.push_back({low, {size.x, 0, 0}, {0, size.y, 0}, to_rgba(theme.grid, 0.6f * strength(count))});
    }
  }
  return faces;
}

/// The edges of the fullest cells; of equally full ones, those nearest to the viewer. Writes how full they are.
void draw_densest(const GridInspection& grid, const std::vector<int>& counts, const FrameView& view, Painter& painter) {
  struct Cell {
    int count;
    float distance;
    IVec3 at;
  };
  std::vector<Cell> cells;
  IVec3 at(0);
  for (at.z = 0; at.z < grid.cells.z; ++at.z) {
    for (at.y = 0; at.y < grid.cells.y; ++at.y) {
      for (at.x = 0; at.x < grid.cells.x; ++at.x) {
        const int count = counts[index_of(grid, at)];
        if (count == 0) continue;
        cells.push_back({count, length(lattice_point(grid, view.domain, at) - view.camera.eye), at});
      }
    }
  }
  const auto occupied = static_cast<int64_t>(cells.size());
  const auto end = cells.begin() + static_cast<std::ptrdiff_t>(std::min(cells.size(), kDensest));
  std::partial_sort(cells.begin(), end, cells.end(), [](const Cell& a, const Cell& b) {
    return a.count != b.count ? a.count > b.count : a.distance < b.distance;
  });
  cells.erase(end, cells.end());
  if (cells.empty()) return;
  std::vector<Line> lines;
  for (const Cell& cell : cells) {
    const Vec3 low = lattice_point(grid, view.domain, cell.at), high = lattice_point(grid, view.domain, cell.at + 1);
    add_box_edges(low, high, to_rgba(painter.theme.grid), lines);
  }
  painter.draw_shining(lines, painter.theme.background, kDenseWidth, kDenseRim);
  const int least = cells.back().count, most = cells.front().count;
  painter.note(
      {{Swatch::line, painter.theme.grid, phrase("densest {} of {} cells:", cells.size(), grouped(occupied))},
       {Swatch::none,
        {},
        least < most ? phrase("{} to {} spheres each", least, most) : phrase("{} each", counted(most, "sphere"))}});
}

/// The borders of all cells, except on the edges of the domain.
std::vector<Line> plane_lines(const GridInspection& grid, const DomainBox& domain, const Theme& theme) {
  std::vector<Line> lines;
  const Rgba color = to_rgba(theme.grid);
  const auto on_border = [&](const Vec3& point, int axis) {
    const float tolerance = 1e-3f * grid.edge[axis];
    return std::abs(point[axis] - domain.min[axis]) < tolerance || std::abs(point[axis] - domain.max[axis]) < tolerance;
  };
  for (const int axis : {0, 1}) {
    for (int k = 0; k <= grid.cells[axis]; ++k) {
      IVec3 from(0), to = grid.cells;
      from[axis] = to[axis] = k;
      to.z = 0;
      const Vec3 start = lattice_point(grid, domain, from);
      if (!on_border(start, axis)) lines.push_back({start, color, lattice_point(grid, domain, to), color});
    }
  }
  return lines;
}

/// Writes "n = 2" into the upper right corner of each occupied cell, if there is room.
void draw_counts(const GridInspection& grid, const std::vector<int>& counts, const FrameView& view, Painter& painter) {
  const Projection projection(view.camera, painter.sheet);
  const auto text_of = [](int count) { return fmt::format("n = {}", count); };
  const Vec2 widest = painter.sheet.size_of(text_of(*std::max_element(counts.begin(), counts.end())), TextSize::small);
  const Vec2 inset = Vec2(8, 3) * painter.sheet.unit(), wanted = widest + 2.0f * inset;
  const Vec2 cell(projection.length_at(grid.origin, grid.edge.x), projection.length_at(grid.origin, grid.edge.y));
  if (cell.x < wanted.x || cell.y < 1.5f * wanted.y) return;
  for (int y = 0; y < grid.cells.y; ++y) {
    for (int x = 0; x < grid.cells.x; ++x) {
      const int count = counts[index_of(grid, {x, y, 0})];
      if (count == 0) continue;
      const Vec2 corner = projection.at(lattice_point(grid, view.domain, {x + 1, y + 1, 0}));
      painter.sheet.bordered_text(corner + Vec2(-inset.x, inset.y), kUpperRight, to_rgba(painter.theme.cell_text),
                                  to_rgba(painter.theme.background), text_of(count), TextSize::small);
    }
  }
}

}  // namespace

Vec3 lattice_point(const GridInspection& grid, const DomainBox& domain, const IVec3& corner) {
  Vec3 point = grid.origin + grid.edge * Vec3(corner);
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const bool has_wall = axis != 1 || !domain.open_top;
    if (has_wall && corner[axis] == grid.cells[axis]) point[axis] = std::min(point[axis], domain.max[axis]);
  }
  return point;
}

std::vector<int> count_per_cell(const GridInspection& grid) {
  std::vector<int> counts(grid.head.size(), 0);
  for (size_t cell = 0; cell < counts.size(); ++cell) {
    for (int32_t body = grid.head[cell]; body >= 0; body = grid.next[static_cast<size_t>(body)]) ++counts[cell];
  }
  return counts;
}

bool draws_densest(const FrameView& view) {
  return !view.domain.is_planar() && view.inspection.bodies.count > kCrowdOfCells;
}

void draw_grid(const FrameView& view, Painter& painter) {
  const float width = kEdgeWidth * painter.line_unit;
  const Projection projection(view.camera, painter.sheet);
  const float thin = std::max(kThinnest, line_scale(view, projection, painter.sheet.unit())) * width;
  for (const GridInspection& grid : view.inspection.grids) {
    if (grid.head.empty()) continue;
    const std::vector<int> counts = count_per_cell(grid);
    if (view.domain.is_planar()) {
      painter.faces.draw(occupied_faces(grid, counts, view, painter.theme));
      painter.lines.draw(plane_lines(grid, view.domain, painter.theme), thin);
      if (!view.shows("labels")) draw_counts(grid, counts, view, painter);
    } else if (draws_densest(view)) {
      draw_densest(grid, counts, view, painter);
    } else {
      painter.lines.draw(occupied_edges(grid, counts, view, painter.theme), (1 + 0.5f * boldness(counts)) * width);
    }
  }
  draw_selection(view, painter);
}

}  // namespace ballpit
