// SPDX-License-Identifier: MIT
// Spheres at rest for experiments on searches, with random centres that may overlap. Equal arguments give equal
// spheres.
#pragma once

#include "world/pair_search.h"

namespace ballpit {

/// Lengths are in diameters of the largest sphere.
struct SphereSet {
  std::vector<Vec3> position;
  std::vector<float> radius;  ///< one for all, or one for each

  SphereArrays arrays() const {
    return {{position.data(), static_cast<int64_t>(position.size())},
            {radius.data(), static_cast<int64_t>(radius.size())}};
  }
};

struct UniformSpheres {
  int64_t count = 0;
  double volume_fraction = 0.3;  ///< of the box, overlaps counted twice
  double size_ratio = 1;         ///< of the largest radius to the smallest; between, the density of radii is ~ r⁻³
  double aspect = 1;             ///< the box's height (z) over its width
};

/// Centres uniform in a box.
SphereSet uniform_spheres(const UniformSpheres& wanted, uint64_t seed);

/// The box of uniform_spheres() [diameters].
Vec3d box_of(const UniformSpheres& wanted);

/// `count` spheres (an even number) in pairs that just touch, each in a random direction. Pairs do not touch each
/// other: each has a random place in its own cell of a wide lattice.
SphereSet touching_pairs(int64_t count, uint64_t seed);

/// Equal spheres in Gaussian clouds of about a thousand with a standard deviation of 3.5 diameters.
SphereSet clouds(int64_t count, uint64_t seed);

}  // namespace ballpit
