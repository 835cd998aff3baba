// SPDX-License-Identifier: MIT
// Random scenes on which `choose` is judged, as scene files: families of motion, sizes, needs and units. A scene
// follows from its seed; one of seed k is of family k mod 7.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace ballpit {

inline constexpr std::array<std::string_view, 7> kHeldOutFamilies{"gas",    "heap",    "stack", "cradle",
                                                                  "bullet", "mixture", "planar"};

/// The units in which a scene is written. The motion is the same in all.
struct Units {
  double length = 1;  ///< [m]
  double time = 1;    ///< [s]
  double mass = 1;    ///< [kg]
};

/// Powers of ten that a seed draws: lengths from 1e-3 to 1e3 m, times from 0.1 to 100 s (shorter ones
/// would take stiffer springs than a scene may have), masses from 1e-3 to 1e3 kg.
Units drawn_units(uint64_t seed);

struct HeldOutScene {
  std::string_view family;
  std::string text;  ///< a scene file
};

/// `tolerance` scales all tolerances.
HeldOutScene held_out_scene(uint64_t seed, const Units& units, double tolerance = 1);

}  // namespace ballpit
