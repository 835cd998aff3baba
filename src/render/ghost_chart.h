// SPDX-License-Identifier: MIT
// The curve of the distance from exact motion, for picture and panel: on a logarithmic
// axis, over the time since the ghost was dropped.
//
//     10²  │        ┊  ╭───── largest, thin
//          │      ┈┈┊╭╯╭───── median, bold
//     1    │    ┈┈ ╭┊╯╭╯      ┈ grows as Lyapunov's exponent says, from the median when each sphere had collided once
//     10⁻³ │ ╭─────╯┊         ┊ the first wrong collision
//          └────────┴─────────
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "world/ghost_inspection.h"

namespace ballpit {

/// Places in the chart: x from 0 at the left to 1, y from 0 at the bottom to 1.
struct GhostChart {
  int low = -3, high = 1;   ///< powers of ten [radii] at the bottom and at the top
  double from = 0, to = 0;  ///< [s] at the left and at the right
  std::vector<Vec2> median, largest;
  std::optional<std::array<Vec2, 2>> growth;
  std::optional<float> wrong;  ///< x

  float height_of(double distance) const;  ///< y; not above the top or below the bottom
};

GhostChart chart_of(const GhostInspection& ghost);

/// In the language set: "late by 2.10 ms", "missed".
std::string timing_text(const WrongCollision& wrong);

/// In the language set: "spheres 3 and 17", "sphere 3 and a wall".
std::string bodies_text(const WrongCollision& wrong);

/// In the language set: "t = 0.532 s".
std::string time_text(double time);

}  // namespace ballpit
