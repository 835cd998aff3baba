// SPDX-License-Identifier: MIT
// What overlays draw with. Two places of the picture are shared out, so that overlays do not lie over one another:
//
//     ┌──────────────────────────┐
//     │ ─ 12 apart  ━ 3 contacts │   note(): one line of legend after the other, downwards
//     │ → longest arrow: 2.3 m/s │
//     │                          │
//     │▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒│   take_strip(): full width, one above the other, upwards
//     └──────────────────────────┘
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/numbers.h"
#include "render/face_renderer.h"
#include "render/line_renderer.h"
#include "render/sheet.h"
#include "render/theme.h"

namespace ballpit {

/// How a thing looks in the picture, as a sample beside its name.
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
  Sheet& sheet;  ///< in pixels of the picture, before all that is drawn in space
  const Theme& theme;
  float line_unit;  ///< [pixel] 1/1080 of the picture's height, so that every size of picture is the same
                    ///< design
  float noted = 0;  ///< [pixel] height of the notes so far
  float taken = 0;  ///< [pixel] height of the strips so far

  /// A line of legend in the upper left corner, below those before.
  void note(const std::vector<NotePart>& parts);

  /// A place at the lower edge, on a translucent ground.
  Strip take_strip(float height);

  Rgba ink(float opacity = 1) const { return to_rgba(theme.text, opacity); }
  Rgba ground() const { return to_rgba(theme.background, 0.85f); }
};

/// (1, "contact") → "1 contact"; (1200, "contact") → "1 200 contacts".
std::string counted(int64_t number, const std::string& noun);

}  // namespace ballpit
