// SPDX-License-Identifier: MIT
// The scene of `ballpit bench`: a gas of equal elastic spheres, of the same density for any number of them.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace ballpit {

inline constexpr double kGasVolumeFraction = 0.3;  ///< of the box, taken up by spheres
inline constexpr double kGasStep = 1.0 / 960;      ///< [s] a sphere flies a tenth of its radius in it
inline constexpr int kGasStepsToEquilibrium = 20;  ///< until contacts are as frequent as they stay

/// `count` spheres of 1 cm radius and up to 1 m/s in a cube of the size that they need: on a cubic lattice, jittered as
/// far as they cannot touch, in shuffled order. The same for every call with the same seed.
Scene make_gas(int64_t count, uint64_t seed = 1);

}  // namespace ballpit
