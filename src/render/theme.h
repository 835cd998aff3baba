// SPDX-License-Identifier: MIT
// One colour for one meaning, on two grounds. Hues are Okabe and Ito's, safe for colour-blind viewers.
#pragma once

#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/math.h"
#include "render/contrast.h"

namespace ballpit {

/// 0x8FA9C4 → (0x8F, 0xA9, 0xC4) / 255.
inline Vec3 rgb(unsigned hex) { return Vec3(hex >> 16 & 255u, hex >> 8 & 255u, hex & 255u) / 255.0f; }

/// Colours as encoded (sRGB) values from 0 to 1.
struct Theme {
  std::string_view name;
  std::string_view label;
  Vec3 background;
  Vec3 text;
  Vec3 floor;      ///< the plane under the spheres
  float shadow;    ///< darkness of the shadow under a sphere that lies on the floor, 0 to 1
  float ambient;   ///< light from all around, 0 to 1
  float key;       ///< light from one side, 0 to 1
  float edge;      ///< how much darker the edge of a sphere is, 0 to 1: on light ground, so that it is seen all round
  Vec3 domain;     ///< the box
  Vec3 cell_text;  ///< numbers and counts of cells, on any tint

  Vec3 body = rgb(0x8FA9C4);       ///< a sphere without a mark
  Vec3 contact = rgb(0xE69F00);    ///< a sphere that touches another, with a dark rim
  Vec3 grid = rgb(0x009E73);       ///< cells
  Vec3 candidate = rgb(0x56B4E9);  ///< a pair that is tested and does not touch: a line with a dark rim
  Vec3 missed = rgb(0xD55E00);     ///< a contact that the method does not find
  Vec3 selected = rgb(0xCC79A7);   ///< the selected sphere and its block, with a rim
  Vec3 begin = rgb(0x0072B2);      ///< an interval's ends, and the thread that walks between them
  Vec3 idle = rgb(0x808080);       ///< an empty entry, or a thread that ends at once
  Vec3 reference = rgb(0x808080);  ///< theory, and exact motion: dotted
};

/// Text on a filled shape: dark or light, by what is more legible.
inline Vec3 text_on(const Vec3& fill) {
  const Vec3 dark = rgb(0x1A1A1A), light = rgb(0xFFFFFF);
  return contrast(dark, fill) >= contrast(light, fill) ? dark : light;
}

/// All themes; the first is the default.
inline const std::vector<Theme>& themes() {
  static const std::vector<Theme> table = {
      {.name = "projector",
       .label = "Projector (white)",
       .background = rgb(0xFFFFFF),
       .text = rgb(0x1A1A1A),
       .floor = rgb(0xF1F3F5),
       .shadow = 0.45f,
       .ambient = 0.55f,
       .key = 0.62f,
       .edge = 0.45f,
       .domain = rgb(0x9A6200),
       .cell_text = rgb(0x005A41)},
      {.name = "dark",
       .label = "Dark",
       .background = rgb(0x14171C),
       .text = rgb(0xE8EAED),
       .floor = rgb(0x23272E),
       .shadow = 0.6f,
       .ambient = 0.38f,
       .key = 0.65f,
       .edge = 0.25f,
       .domain = rgb(0xE69F00),
       .cell_text = rgb(0x8CE8CB)},
  };
  return table;
}

/// Throws UserError that lists the themes.
inline const Theme& theme_named(std::string_view name) { return entry_named(themes(), name, "--theme"); }

}  // namespace ballpit
