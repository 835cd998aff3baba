// SPDX-License-Identifier: MIT
// The spheres that `ballpit pairs` searches: those of a CSV file or of a scene, and the period in which they repeat.
#pragma once

#include <optional>
#include <string>

#include "core/math.h"
#include "scene/spheres_csv.h"
#include "world/pair_search.h"

namespace ballpit {

struct PairInput {
  RestingSpheres spheres;
  std::optional<Vec3d> period;   ///< [m] along each axis, 0 where there is none; empty without any
  std::optional<Box<Vec3>> box;  ///< the same as a domain that holds all centres
};

/// "X,Y,Z" [m], 0 for an axis without a period. Throws UserError.
Vec3d parse_period(const std::string& text);

/// Reads a CSV file, a scene file or a built-in scene, and tells what the user is to know about it. Centres outside of
/// the period move to their images inside. `period` is for CSV files: a scene has its own. Throws UserError where it is
/// given with a scene, or is too short for the spheres.
PairInput read_pair_input(const std::string& file, const std::optional<Vec3d>& period);

}  // namespace ballpit
