// SPDX-License-Identifier: MIT
// What overlays draw with. It assigns two areas of the picture, so that overlays do not cover each other:
//
//     ┌──────────────────────────┐
//     │ ─ 12 apart  ━ 3 contacts │   note(): lines of a legend, downwards
//     │ → longest arrow: 2.3 m/s │
//     │                          │
//     │▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒│   take_strip(): full width, upwards
//     └──────────────────────────┘
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/numbers.h"
#include "render/shapes.h"
#include "render/sheet.h"
#include "render/theme.h"

namespace ballpit {

/// A sample in the legend of how something looks in the picture.
enum class Swatch { none, line, bold, twice, arrow, square };

struct NotePart {
  Swatch swatch;
  Vec3 color;
  std::string text;
};

/// From top to bottom, over the picture's whole width [pixel].
struct Strip {
  float top, bottom;
};

struct Painter {
  LineRenderer& lines;
  FaceRenderer& faces;
  Sheet& sheet;  ///< in pixels, in front of everything that is drawn in space
  const Theme& theme;
  float line_unit;  ///< [pixel] 1/1080 of the picture's height, so that lines look the same at every size
  float noted = 0;  ///< [pixel] height of the notes so far
  float taken = 0;  ///< [pixel] height of the strips so far

  /// Adds a line to the legend in the upper left corner.
  void note(const std::vector<NotePart>& parts);
  void note(const std::string& text) { note({{Swatch::none, {}, text}}); }

  /// Takes a strip at the lower edge and gives it a translucent ground.
  Strip take_strip(float height);

  Rgba ink(float opacity = 1) const { return to_rgba(theme.text, opacity); }
  Rgba ground() const { return to_rgba(theme.background, 0.85f); }
};

/// (1, "contact") → "1 contact"; (1200, "contact") → "1 200 contacts".
std::string counted(int64_t number, const std::string& noun);

}  // namespace ballpit
