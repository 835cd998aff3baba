// SPDX-License-Identifier: MIT
// The room for the spheres of a [[fill]]: the box of their centres, the sites of a lattice, and the volume fraction.
// Positions are exact in float.
#pragma once

#include <algorithm>

#include "scene/fill.h"

namespace ballpit {

/// `value` rounded to the 24 bits of a float by Veltkamp's method (Dekker 1971, doi 10.1007/BF01397083). Not by casts to float
/// and back: g++ 12 removes both casts when it vectorises them (-ftree-slp-vectorize).
double as_float(double value);
Vec3d as_float(const Vec3d& p);

/// The box for the centre of a sphere, ends included, except the upper end of a periodic axis.
struct CentreBox {
  Vec3d low;
  Vec3d high;
  bool periodic[3] = {false, false, false};

  bool contains(const Vec3d& p) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] < low[axis] || p[axis] > high[axis]) return false;
      if (periodic[axis] && p[axis] == high[axis]) return false;
    }
    return true;
  }
};

/// Throws UserError if the region is too small for a sphere of this radius.
CentreBox centre_box(const Domain& domain, const Fill& fill, double radius);

/// Sites at low + (i, j, k) · spacing, in the order i, k, j: from the floor up.
struct Lattice {
  Vec3d low;
  double spacing;
  int64_t sites[3];

  int64_t size() const {
    const double product =
        static_cast<double>(sites[0]) * static_cast<double>(sites[1]) * static_cast<double>(sites[2]);
    return static_cast<int64_t>(std::min(product, 1e18));
  }
  Vec3d site(int64_t index) const {
    const int64_t i = index % sites[0];
    const int64_t k = index / sites[0] % sites[2];
    const int64_t j = index / sites[0] / sites[2];
    return as_float(low + Vec3d(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)) * spacing);
  }
};

/// As narrow as the largest sphere of the fill allows.
Lattice lattice_of(const Domain& domain, const Fill& fill);

/// The number of a fill's spheres, up to its count, for which a lattice has free sites beside the spheres in `index`.
int64_t free_sites(const Domain& domain, const Fill& fill, const SphereIndex& index);

/// The mean volume [m³] of the spheres of a fill, as a fraction of its region's; areas in the plane.
double volume_fraction(const Domain& domain, const Fill& fill);

}  // namespace ballpit
