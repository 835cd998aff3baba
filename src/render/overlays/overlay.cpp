// SPDX-License-Identifier: MIT
#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

constexpr const char* kNoCells = "this broad phase has no cells; choose linked-cell or sorted-grid";

std::string lacks_cells(const Inspection& inspection) {
  const std::vector<GridInspection>& grids = inspection.grids;
  if (grids.empty()) return kNoCells;
  const bool shows_none = std::all_of(grids.begin(), grids.end(), [](const auto& grid) { return grid.head.empty(); });
  return shows_none ? "this broad phase has too many cells to show; enlarge them" : "";
}

std::string lacks_lists(const Inspection& inspection) { return inspection.grids.empty() ? kNoCells : ""; }

std::string lacks_intervals(const Inspection& inspection) {
  return inspection.axis < 0 ? "this broad phase sorts no intervals; choose sort-and-sweep" : "";
}

std::string lacks_warps(const Inspection& inspection) {
  return inspection.work.empty() ? "this broad phase has no thread for each sphere" : "";
}

std::string lacks_ghost(const Inspection& inspection) {
  if (!inspection.ghost) return "no exact motion runs beside this one";
  return std::string(inspection.ghost->lack);
}

}  // namespace

const std::vector<OverlayEntry>& overlay_table() {
  static const std::vector<OverlayEntry> table = {
      {"grid", "Grid cells", draw_grid, {}, nullptr, lacks_cells, true},
      {"pairs", "Pairs", draw_pairs, {.candidates = true, .missed = true}, nullptr, nullptr, false, 2},
      {"velocity", "Velocities", draw_velocities, {}, nullptr, nullptr, false, 1},
      {"swept", "Swept ways", draw_swept, {}, nullptr, nullptr, false, 1},
      {"labels", "Numbers", draw_labels, {}, nullptr, nullptr, false, 1},
      {"lists", "Lists", draw_lists, {}, lists_room, lacks_lists, false, 1},
      {"intervals", "Intervals", draw_intervals, {.endpoints = true}, intervals_room, lacks_intervals, false, 3},
      {"warps", "Warps", draw_warps, {.work = true}, warps_room, lacks_warps, false, 2},
      {"ghost", "Exact ghost", draw_ghost, {.ghost = true}, ghost_room, lacks_ghost, false, 4},
  };
  return table;
}

float room_below(const std::vector<std::string>& overlays, const Inspection& inspection, float text_scale) {
  constexpr float kMaxRoom = 0.5f;  // the scene needs the rest
  float room = 0;
  for (const OverlayEntry& entry : overlay_table()) {
    const bool enabled = std::find(overlays.begin(), overlays.end(), entry.name) != overlays.end();
    if (enabled && entry.room_below) room += entry.room_below(inspection, text_scale);
  }
  return std::min(room, kMaxRoom);
}

}  // namespace ballpit
