// SPDX-License-Identifier: MIT
// The scene of `ballpit bench`: a gas of equal elastic spheres, whose density is the same for any number of spheres.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace ballpit {

inline constexpr double kGasVolumeFraction = 0.3;  ///< of the box
inline constexpr double kGasStep = 1.0 / 960;      ///< [s] in which a sphere moves a tenth of its radius at most
inline constexpr int kGasStepsToEquilibrium = 20;  ///< after which the number of contacts stays constant

/// `count` spheres of 1 cm radius and up to 1 m/s in a cube of the right size: on a cubic lattice, each displaced at
/// random without touching another, in shuffled order. Equal seeds give equal scenes.
Scene make_gas(int64_t count, uint64_t seed = 1);

}  // namespace ballpit
