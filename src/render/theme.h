// SPDX-License-Identifier: MIT
// One colour for one meaning, on two grounds. Hues are Okabe and Ito's, safe for colour-blind viewers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/math.h"

namespace ballpit {

/// Colours as encoded (sRGB) values from 0 to 1.
struct Theme {
  std::string_view name;
  std::string_view label;
  Vec3 background;
  Vec3 text;
  Vec3 floor;      ///< the plane under the spheres
  Vec3 body;       ///< a sphere without a mark
  Vec3 contact;    ///< a sphere that touches another
  Vec3 grid;       ///< cells
  Vec3 domain;     ///< the box
  Vec3 candidate;  ///< a pair that is tested and does not touch
  Vec3 missed;     ///< a contact that the method does not find
  Vec3 selected;   ///< the sphere that the audience looks at, and its block
  Vec3 begin;      ///< an interval's ends, and the thread that walks between them
  Vec3 idle;       ///< what has nothing to do: empty, or at its end at once
  Vec3 on_body;    ///< text on spheres and other light colours
  float shadow;    ///< darkness of the shadow under a sphere that lies on the floor, 0 to 1
  float ambient;   ///< light from all around, 0 to 1
  float key;       ///< light from one side, 0 to 1
};

/// All themes; the first is the default.
const std::vector<Theme>& themes();

/// Throws UserError that lists the themes.
const Theme& theme_named(const std::string& name);

}  // namespace ballpit
