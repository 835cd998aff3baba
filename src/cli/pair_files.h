// SPDX-License-Identifier: MIT
// The files of `ballpit pairs`: the spheres of a CSV file or a scene, with the period after which they repeat; and pairs
// as CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/math.h"
#include "scene/spheres_csv.h"
#include "world/pair_search.h"

namespace ballpit {

struct PairInput {
  RestingSpheres spheres;
  std::optional<Vec3d> period;   ///< [m] along each axis, 0 for none; empty without any
  std::optional<Box<Vec3>> box;  ///< the same as a domain that holds all centres
};

/// "X,Y,Z" [m], 0 for an axis without a period. Throws UserError.
Vec3d parse_period(const std::string& text);

/// Reads a CSV file, a scene file or a built-in scene, and prints warnings about it. Centres outside of the period move
/// to their images inside. Throws UserError if `period` is too short for the spheres, or is given with a scene, which
/// has its own.
PairInput read_pair_input(const std::string& file, const std::optional<Vec3d>& period);

/// "i,j", then one pair a line.
std::string pairs_csv(const std::vector<Pair>& pairs);

}  // namespace ballpit
