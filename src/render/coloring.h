// SPDX-License-Identifier: MIT
// What a sphere's colour says: whether it touches another, or a quantity on a scale of sixteen colours, with a legend. The scale is
// cividis: dark to light, so that colour-blind viewers and prints in grey read the same order.
// Source: Nuñez, Anderton, Renslow, "Optimizing colormaps with consideration for color vision deficiency" (2018),
// doi 10.1371/journal.pone.0199239.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/body_buffer.h"
#include "render/theme.h"
#include "world/inspection.h"

namespace ballpit {

struct Painter;

/// The marks of all bodies, and what the ends of the scale mean; empty where there is no scale.
struct Colored {
  std::vector<Mark> marks;
  std::string low, high;
  std::string lacking{};  ///< why there is nothing to show
};

struct ColoringEntry {
  std::string_view name;   ///< "speed", as typed
  std::string_view label;  ///< "Speed", as the audience reads it
  Colored (*color)(const Inspection&);
  Wanted wanted = {};  ///< of the inspection; no state where a BodyWriter's marks say all
};

/// All colourings; the first is the default.
const std::vector<ColoringEntry>& coloring_table();

/// Throws UserError that lists the colourings.
const ColoringEntry& coloring_named(std::string_view name);

/// The colours of marks in their order.
Vec3 color_of(const Theme& theme, int mark);

/// The scale and what its ends mean, or why there is none, in the upper right corner.
void draw_legend(const ColoringEntry& coloring, const Colored& colored, Painter& painter);

}  // namespace ballpit
