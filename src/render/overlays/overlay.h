// SPDX-License-Identifier: MIT
// Overlays show over the spheres what the simulation does. Each is a function that reads only the inspection, and one entry
// of the table that command line, panel and tests use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/frame_view.h"
#include "world/inspection.h"

namespace ballpit {

struct Painter;  // render/painter.h: what all overlays draw with

struct OverlayEntry {
  std::string_view name;                             ///< "grid", as typed
  std::string_view label;                            ///< "Grid cells", as the panel shows it
  void (*draw)(const FrameView&, Painter&);          ///< only a note if the inspection lacks the data
  Wanted wanted = {};                                ///< of the inspection, for drawing
  float (*room_below)(const Inspection&) = nullptr;  ///< part of the picture's height that it fills at the lower edge
  std::string (*lacking)(const Inspection&) = nullptr;  ///< why the method gives it nothing to draw; "" if it does
  bool is_under_discs = false;                          ///< in planar scenes; all others are drawn after the bodies

  std::string lack(const Inspection& inspection) const { return lacking ? lacking(inspection) : ""; }
};

/// All overlays, in the order in which they are drawn.
const std::vector<OverlayEntry>& overlay_table();

/// The part of the picture's height that these overlays fill together at the lower edge, for leave_room_below().
float room_below(const std::vector<std::string>& overlays, const Inspection& inspection);

}  // namespace ballpit
