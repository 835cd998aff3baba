// SPDX-License-Identifier: MIT
// The option mass-ratio: how much heavier the heavy spheres of a scene are than its light ones. Cost: O(n).
#pragma once

#include "scene/scene.h"
#include "scene/table_reader.h"

namespace ballpit {

/// If a ratio is given, as --mass-ratio, or else by [defaults] mass-ratio, makes the heavier ones of two kinds of
/// spheres so many times as heavy as the lighter ones, which keep their mass. Throws UserError unless the spheres have
/// exactly two masses: with one or three it is not clear which are meant.
void override_masses(const TableReader& root, std::optional<double> given, Bodies& bodies);

}  // namespace ballpit
