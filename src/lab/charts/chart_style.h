// SPDX-License-Identifier: MIT
// How charts look: colours, markers and words of a role, on either ground. Hues are Okabe and Ito's, safe for
// colour-blind viewers; a marker says the same as each colour does.
#pragma once

#include <string>
#include <string_view>

#include "lab/charts/chart.h"

namespace ballpit {

using Rgb = unsigned;  ///< 0xRRGGBB

struct RoleStyle {
  std::string_view role;
  Rgb light, dark;         ///< colour on light and on dark ground
  int open, filled;        ///< gnuplot's point types: the marker as an outline, and its inside
  std::string_view glyph;  ///< the marker in a line of text
};

/// Throws std::logic_error for a role that there is not.
const RoleStyle& style_of(std::string_view role);

struct GroundStyle {
  Rgb background, text, faint, theory;
};

const GroundStyle& ground_style(Ground ground);

Rgb color_of(std::string_view role, Ground ground);

/// The same hue, moved away from the ground until text in it can be read: a contrast of at least 4 (WCAG 2.1).
Rgb text_color_of(std::string_view role, Ground ground);

/// The colour for a share of 0 to 1: from dark blue over green to yellow, ever lighter (viridis, Smith and van der Walt
/// 2015).
Rgb gradient(double share);

/// "#0072B2"
std::string hex(Rgb color);

}  // namespace ballpit
