// SPDX-License-Identifier: MIT
// Overlays show what the simulation does, over the spheres: each owns its drawing, reads only the inspection,
// and is one entry of the table that feeds command line, panel and tests.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/frame_view.h"
#include "world/inspection.h"

namespace ballpit {

struct Painter;  // render/painter.h: what all overlays draw with

/// When an overlay draws: `under` before the bodies, `over` after them. Depth is tested in both.
enum class Layer { under, over };

class Overlay {
 public:
  Overlay() = default;
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;
  virtual ~Overlay() = default;

  /// Called twice a frame, once for each layer. Draws nothing but a note where the inspection lacks what it shows.
  virtual void draw(const FrameView& view, Painter& painter, Layer layer) = 0;
};

struct OverlayEntry {
  std::string_view name;                                ///< "grid", as typed
  std::string_view label;                               ///< "Grid cells", as the panel shows it
  std::unique_ptr<Overlay> (*create)();                 ///< needs a current GL context
  Wanted wanted = {};                                   ///< of the inspection, to be drawn
  float (*room_below)(const Inspection&) = nullptr;     ///< of the picture's height, that it fills at the lower edge
  std::string (*lacking)(const Inspection&) = nullptr;  ///< why the method gives it nothing to draw; "" where it does

  std::string lack(const Inspection& inspection) const { return lacking ? lacking(inspection) : ""; }
};

const std::vector<OverlayEntry>& overlay_table();

/// What these overlays together fill at the lower edge: a fraction of the picture's height, for leave_room_below().
float room_below(const std::vector<std::string>& overlays, const Inspection& inspection);

}  // namespace ballpit
