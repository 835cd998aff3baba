// SPDX-License-Identifier: MIT
// The meaning of a sphere's colour: whether the sphere touches another, or a quantity on a scale of sixteen colours, with a
// legend. The scale is cividis, from dark to light: its order is visible for colour-blind viewers and in grey prints.
// Source: Nuñez, Anderton, Renslow, "Optimizing colormaps with consideration for color vision deficiency" (2018),
// doi 10.1371/journal.pone.0199239.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/color_scale.h"
#include "render/theme.h"

namespace ballpit {

struct Painter;

struct ColoringEntry {
  std::string_view name;   ///< "speed", as typed
  std::string_view label;  ///< "Speed", as the audience reads it
  Colored (*color)(const Inspection&);
  Wanted wanted = {};  ///< of the inspection; no state if the marks that a world writes are sufficient
};

/// All colourings; the first is the default.
const std::vector<ColoringEntry>& coloring_table();

/// Throws UserError that lists the colourings.
const ColoringEntry& coloring_named(std::string_view name);

/// The colour of a mark.
Vec3 color_of(const Theme& theme, int mark);

/// [1/1080 of the picture's height] Width of the dark rim of spheres with a mark: of those that touch another, and, thinner,
/// of colours that are too pale for the ground. 0: none.
float rim_width(const Theme& theme, int mark);

/// Draws the name of the quantity and its scale, or the reason why there is none, in two lines in the upper right corner.
void draw_legend(const ColoringEntry& coloring, const Colored& colored, Painter& painter);

}  // namespace ballpit
