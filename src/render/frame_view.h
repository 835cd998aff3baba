// SPDX-License-Identifier: MIT
// The content of one picture.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/camera.h"
#include "world/inspection.h"

namespace ballpit {

struct FramedBox {
  Vec3 min, max;  ///< [m]
};

/// The box as it is drawn.
struct DomainBox {
  Vec3 min{0.0f};  ///< [m]
  Vec3 max{1.0f};  ///< [m]
  int dimensions = 3;
  bool open_top = false;  ///< no ceiling: spheres may rise above max.y
  bool is_periodic = false;
  std::optional<FramedBox> framed{};  ///< what fills the picture; none: the box

  bool is_planar() const { return dimensions == 2; }
  float longest_edge() const { return std::max({max.x - min.x, max.y - min.y, is_planar() ? 0 : max.z - min.z}); }
};

/// Where notes and legend are, if they need a strip above the scene; fractions of the picture's height and width.
struct NotesRoom {
  float above = 0;  ///< height of the strip, below a title; 0: they lie beside the domain
  float width = 0;  ///< of a note; 0: unknown
  float skip = 0;   ///< height of the legend, if the notes lie below it
};

struct PageView;  // render/page_view.h: what a page of a lecture adds

/// An act that a hand prepares: an arrow of a velocity, and rings around the spheres that will get it.
struct Aim {
  Vec3 from{0.0f}, to{0.0f};  ///< [m]
  float speed = 0;            ///< [m/s]
  bool is_fastest = false;    ///< a step allows no more
  struct Ring {
    Vec3 centre;
    float radius;
  };
  std::vector<Ring> rings{};  ///< [m]
};

/// Refers to the inspection, which must live until the picture is drawn.
struct FrameView {
  bool shows(std::string_view overlay) const {
    return std::find(overlays.begin(), overlays.end(), overlay) != overlays.end();
  }

  const Inspection& inspection;
  DomainBox domain;
  Camera camera;
  std::vector<std::string> overlays;  ///< names from overlay_table(), drawn in the table's order
  int64_t selected = -1;              ///< the selected body, or −1
  std::string coloring = "contact";   ///< from coloring_table()
  float step = 0;                     ///< [s] until the next search for contacts
  Wanted left_out{};                  ///< data that overlays want, but that is too large to be in the inspection
  bool is_written = false;            ///< the world has written bodies and contact marks into the renderer's buffer
  const PageView* page = nullptr;     ///< of a lecture
  float typical_speed = 0;            ///< [m/s] of the scene: much slower spheres count as at rest; 0: unknown
  const Aim* aim = nullptr;           ///< of the mouse
  NotesRoom notes{};
};

}  // namespace ballpit
