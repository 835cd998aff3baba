// SPDX-License-Identifier: MIT
// The look of charts: colours and markers of each role, on a light and on a dark background. The hues are those of
// Okabe and Ito, which colour-blind viewers can tell apart. Each colour has a marker of its own.
#pragma once

#include <string_view>

#include "lab/charts/chart.h"

namespace ballpit {

using Rgb = unsigned;  ///< 0xRRGGBB

struct RoleStyle {
  std::string_view role;
  Rgb light, dark;         ///< colour on a light and on a dark background
  int open, filled;        ///< gnuplot's point types of the marker's outline and of its inside
  std::string_view glyph;  ///< the marker in a line of text
};

/// Throws std::logic_error for an unknown role.
const RoleStyle& style_of(std::string_view role);

struct GroundStyle {
  Rgb background, text, faint, theory;
};

const GroundStyle& ground_style(Ground ground);

Rgb color_of(std::string_view role, Ground ground);

/// The same hue, lighter or darker until text in it is readable: a contrast of at least 4 (WCAG 2.1).
Rgb text_color_of(std::string_view role, Ground ground);

/// The colour for a share of 0 to 1: dark blue, green, yellow (viridis, Smith and van der Walt 2015).
Rgb gradient(double share);

/// "#0072B2"
std::string hex(Rgb color);

}  // namespace ballpit
