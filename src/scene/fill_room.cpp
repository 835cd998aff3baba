// SPDX-License-Identifier: MIT
#include "scene/fill_room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace ballpit {

namespace {

/// [m] The distance from the largest coordinate of the region to the next float.
double float_spacing(const Fill& fill) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    largest = std::max({largest, std::abs(fill.min[axis]), std::abs(fill.max[axis])});
  }
  const auto coordinate = static_cast<float>(largest);
  return double(std::nextafter(coordinate, std::numeric_limits<float>::infinity())) - double(coordinate);
}

/// [m] A radius with few digits that fits between two ends: half the distance, less the room for gaps and rounding.
double fitting_radius(const Fill& fill, double low, double high) {
  const double radius = (0.5 * (high - low) - 2.0 * float_spacing(fill)) / (1.0 + 2.0 * kPlacementGap);
  if (radius <= 0.0) return 0.0;
  const double digit = std::pow(10.0, std::floor(std::log10(radius)) - 3.0);
  return std::floor(radius / digit) * digit;
}

}  // namespace

double as_float(double value) {
  const double c = value * 0x20000001p0;
  return c - (c - value);
}

Vec3d as_float(const Vec3d& p) { return {as_float(p.x), as_float(p.y), as_float(p.z)}; }

CentreBox centre_box(const Domain& domain, const Fill& fill, double radius) {
  CentreBox box{fill.min, fill.max};
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    // Inside the region as written, and as rounded to float.
    box.low[axis] = std::max(box.low[axis], as_float(box.low[axis]));
    box.high[axis] = std::min(box.high[axis], as_float(box.high[axis]));
    box.periodic[axis] = domain.boundary == Boundary::periodic && fill.min[axis] == domain.min[axis] &&
                         fill.max[axis] == domain.max[axis];
    if (box.periodic[axis]) continue;
    const double low = box.low[axis], high = box.high[axis];
    box.low[axis] += radius * (1.0 + kPlacementGap);
    box.high[axis] -= radius * (1.0 + kPlacementGap);
    if (box.low[axis] > box.high[axis]) {
      const double fitting = fitting_radius(fill, low, high);
      throw input_error(
          fill.place, "[[fill]] radius", number_text(radius),
          fitting > 0.0
              ? fmt::format("at most {}, below half the region, whose edge along {} is {}", number_text(fitting),
                            "xyz"[axis], number_text(fill.max[axis] - fill.min[axis]))
              : fmt::format("in a larger region, or nearer to the origin: single precision rounds by {} m here",
                            number_text(float_spacing(fill))));
    }
  }
  return box;
}

Lattice lattice_of(const Domain& domain, const Fill& fill) {
  const double radius = fill.radius_max;
  const CentreBox box = centre_box(domain, fill, radius);
  // Two units in the last place compensate for rounding two neighbours to float.
  const double ulp = float_spacing(fill);
  Lattice lattice{box.low + ulp, 2.0 * radius * (1.0 + 2.0 * kPlacementGap) + 2.0 * ulp, {1, 1, 1}};
  if (domain.dimensions == 2) lattice.low.z = 0.0;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const double room = box.high[axis] - box.low[axis] - 2.0 * ulp;
    // The last site of a periodic axis is the neighbour of the first.
    const double count = std::floor(room / lattice.spacing) + (box.periodic[axis] ? 0.0 : 1.0);
    lattice.sites[axis] = static_cast<int64_t>(std::clamp(count, 0.0, static_cast<double>(kLargestCount)));
  }
  return lattice;
}

int64_t free_sites(const Domain& domain, const Fill& fill, const SphereIndex& index) {
  const Lattice lattice = lattice_of(domain, fill);
  if (index.size() == 0) return std::min(lattice.size(), fill.count);
  int64_t free = 0;
  for (int64_t site = 0; site < lattice.size() && free < fill.count; ++site) {
    free += index.is_free(lattice.site(site), fill.radius_max, kPlacementGap);
  }
  return free;
}

double volume_fraction(const Domain& domain, const Fill& fill) {
  const double a = fill.radius_min, b = fill.radius_max;
  const Vec3d extent = fill.max - fill.min;
  const auto count = static_cast<double>(fill.count);
  if (domain.dimensions == 2) {
    const double mean_square = (a * a + a * b + b * b) / 3.0;
    return count * std::numbers::pi * mean_square / (extent.x * extent.y);
  }
  const double mean_cube = (a * a + b * b) * (a + b) / 4.0;
  return count * (4.0 / 3.0) * std::numbers::pi * mean_cube / (extent.x * extent.y * extent.z);
}

}  // namespace ballpit
