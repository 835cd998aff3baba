// SPDX-License-Identifier: MIT
// Places the spheres of [[fill]] tables without overlap: at random or on a lattice.
//
// random: random sequential addition (dart throwing), the largest sphere first. Placing stops with an error that gives the
// number of placed spheres if a sphere finds no room in kAttemptsPerSphere throws, or if the mean exceeds 30 throws.
// Cost: O(n) as long as the volume fraction is well below saturation, 0.38 for equal spheres and 0.547 for equal discs.
// Source: Widom 1966, J. Chem. Phys. 44, 3888; saturation: Torquato, Uche, Stillinger 2006, doi 10.1103/PhysRevE.74.061308.
//
// lattice: simple cubic, square in the plane, as narrow as the largest sphere allows, row by row from the floor up. Cost: O(sites).
//
// Every position is exact in float and is tested with a relative gap of kPlacementGap between spheres and to walls, so
// rounding positions and radii to float never causes an overlap. The same seed gives the same bits on every platform.
#pragma once

#include <span>

#include "scene/input_error.h"
#include "scene/sphere_index.h"

namespace ballpit {

enum class Arrangement { random, lattice };

inline constexpr double kPlacementGap = 1e-6;
inline constexpr int kAttemptsPerSphere = 20'000;

/// One [[fill]] table, checked as far as possible before its spheres are placed.
struct Fill {
  int64_t count = 0;
  double radius_min = 0.0;        ///< [m] radii are uniform between these
  double radius_max = 0.0;        ///< [m]
  double speed = 0.0;             ///< [m/s] in a random direction for each sphere, if there is no `velocity`
  std::optional<Vec3d> velocity;  ///< [m/s]
  std::optional<double> mass;     ///< [kg], else density · volume
  Vec3d min{0.0};                 ///< [m] spheres are completely inside, except at periodic edges
  Vec3d max{1.0};                 ///< [m]
  Arrangement arrangement = Arrangement::random;
  Place place;  ///< of its count, for errors
  std::string count_key = "[[fill]] count";
};

/// Appends the spheres of all `fills` to `bodies`, in their order, without overlaps with each other and with those in `index`,
/// which must contain `bodies`. Lattices are placed first, then the largest spheres. Throws UserError if a fill does not fit.
void place_fills(const Scene& scene, std::span<const Fill> fills, SphereIndex& index, Bodies& bodies);

}  // namespace ballpit
