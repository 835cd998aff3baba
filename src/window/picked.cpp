// SPDX-License-Identifier: MIT
#include "window/picked.h"

#include <algorithm>
#include <cmath>

namespace ballpit {

namespace {

std::vector<int32_t> list_from(const GridInspection& grid, int32_t head) {
  std::vector<int32_t> bodies;
  for (int32_t b = head; b >= 0; b = grid.next[static_cast<size_t>(b)]) bodies.push_back(b);
  return bodies;
}

/// The cell of a place, or the nearest one if the place is outside the grid.
IVec3 cell_of(const GridInspection& grid, const Vec3& place) {
  IVec3 cell(0);
  for (int axis = 0; axis < 3; ++axis) {
    const float at = (place[axis] - grid.origin[axis]) / grid.edge[axis];
    if (std::isfinite(at))
      cell[axis] = static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(grid.cells[axis] - 1)));
  }
  return cell;
}

}  // namespace

std::optional<ListedIn> listed_in(const Inspection& inspection, int32_t body) {
  for (const GridInspection& grid : inspection.grids) {
    const IVec3 cell = cell_of(grid, inspection.bodies.position_of(body));
    if (grid.head.empty()) continue;
    const int index = (cell.z * grid.cells.y + cell.y) * grid.cells.x + cell.x;
    if (index < 0 || static_cast<size_t>(index) >= grid.head.size()) continue;
    ListedIn found{cell, index, grid.is_sorted(), list_from(grid, grid.head[static_cast<size_t>(index)]), 0};
    if (found.is_sorted) std::reverse(found.bodies.begin(), found.bodies.end());
    const auto at = std::find(found.bodies.begin(), found.bodies.end(), body);
    if (at == found.bodies.end()) continue;
    found.place = static_cast<size_t>(at - found.bodies.begin());
    return found;
  }
  return std::nullopt;
}

std::optional<Interval> interval_of(const Inspection& inspection, int32_t body) {
  Interval found;
  bool has_begin = false, has_end = false;
  for (size_t p = 0; p < inspection.endpoints.size(); ++p) {
    const Endpoint& endpoint = inspection.endpoints[p];
    if (endpoint.body != body) continue;
    (endpoint.is_end ? found.end : found.begin) = endpoint.at;
    (endpoint.is_end ? found.end_place : found.begin_place) = p;
    (endpoint.is_end ? has_end : has_begin) = true;
  }
  return has_begin && has_end ? std::optional(found) : std::nullopt;
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

}  // namespace ballpit
