// SPDX-License-Identifier: MIT
#include "render/overlays/overlay.h"

#include <algorithm>

#include "broad_phase/inspection.h"
#include "core/error.h"
#include "render/overlays/grid.h"
#include "render/overlays/intervals.h"
#include "render/overlays/labels.h"
#include "render/overlays/lists.h"
#include "render/overlays/pairs.h"
#include "render/overlays/swept.h"
#include "render/overlays/velocity.h"
#include "world/inspection.h"

namespace ballpit {

namespace {

template <class Kind>
std::unique_ptr<Overlay> make() {
  return std::make_unique<Kind>();
}

constexpr const char* kNoCells = "this broad phase has no cells to show; linked-cell and sorted-grid have";

std::string lacks_cells(const Inspection& inspection) {
  const std::vector<GridInspection>& grids = inspection.grids;
  if (grids.empty()) return kNoCells;
  const bool shows_none = std::all_of(grids.begin(), grids.end(), [](const auto& grid) { return grid.head.empty(); });
  return shows_none ? "this broad phase has too many cells to show" : "";
}

std::string lacks_lists(const Inspection& inspection) { return inspection.grids.empty() ? kNoCells : ""; }

std::string lacks_intervals(const Inspection& inspection) {
  return inspection.axis < 0 ? "this broad phase sorts no intervals; sort-and-sweep does" : "";
}

}  // namespace

const std::vector<OverlayEntry>& overlay_table() {
  static const std::vector<OverlayEntry> table = {
      {"grid", "Grid cells", make<GridOverlay>, {}, nullptr, lacks_cells},
      {"pairs", "Pairs", make<PairsOverlay>, {.candidates = true, .missed = true}, nullptr},
      {"velocity", "Velocities", make<VelocityOverlay>, {}, nullptr},
      {"swept", "Swept ways", make<SweptOverlay>, {}, nullptr},
      {"labels", "Numbers", make<LabelsOverlay>, {}, nullptr},
      {"lists", "Lists", make<ListsOverlay>, {}, lists_room, lacks_lists},
      {"intervals", "Intervals", make<IntervalsOverlay>, {.endpoints = true}, intervals_room, lacks_intervals},
  };
  return table;
}

float room_below(const std::vector<std::string>& overlays, const Inspection& inspection) {
  constexpr float kMost = 0.5f;  // the scene is the hero
  float room = 0;
  for (const OverlayEntry& entry : overlay_table()) {
    const bool enabled = std::find(overlays.begin(), overlays.end(), entry.name) != overlays.end();
    if (enabled && entry.room_below) room += entry.room_below(inspection);
  }
  return std::min(room, kMost);
}

}  // namespace ballpit
