// SPDX-License-Identifier: MIT
// Spheres at rest for experiments on searches: centres drawn at random, overlaps as chance has them. The same for every
// call with the same arguments.
#pragma once

#include <cstdint>
#include <vector>

#include "world/pair_search.h"

namespace ballpit {

/// Lengths are in units of which the largest spheres are one across.
struct SphereSet {
  std::vector<Vec3> position;
  std::vector<float> radius;  ///< one value where all are equal, or one each

  SphereArrays arrays() const {
    return {{position.data(), static_cast<int64_t>(position.size())},
            {radius.data(), static_cast<int64_t>(radius.size())}};
  }
};

struct UniformSpheres {
  int64_t count = 0;
  double volume_fraction = 0.3;  ///< of the box, overlaps counted twice
  double size_ratio = 1;         ///< largest to smallest radius; between, the density of radii goes as r⁻³
  double aspect = 1;             ///< the box's height (z) over its width
};

/// Centres drawn evenly from a box.
SphereSet uniform_spheres(const UniformSpheres& wanted, uint64_t seed);

/// The box of uniform_spheres() [diameters].
Vec3d box_of(const UniformSpheres& wanted);

/// `count` spheres in pairs that just touch, each in a random direction. Pairs never meet: each is somewhere in a cell of its
/// own of a wide lattice. `count` is even.
SphereSet touching_pairs(int64_t count, uint64_t seed);

/// Equal spheres in Gaussian clouds of about a thousand, each 3.5 diameters wide (standard deviation).
SphereSet clouds(int64_t count, uint64_t seed);

}  // namespace ballpit
