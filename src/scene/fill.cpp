// SPDX-License-Identifier: MIT
#include "scene/fill.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "core/random.h"

namespace ballpit {

namespace {

/// [m] The distance from the largest coordinate of the region to the next float.
double float_spacing(const Fill& fill) {
  const Vec3d largest = glm::max(glm::abs(fill.min), glm::abs(fill.max));
  const auto coordinate = static_cast<float>(std::max({largest.x, largest.y, largest.z}));
  return double(std::nextafter(coordinate, std::numeric_limits<float>::infinity())) - double(coordinate);
}

/// [m] A radius with few digits that fits between two ends: half the distance, less the room for gaps and rounding.
double fitting_radius(const Fill& fill, double low, double high) {
  const double radius = (0.5 * (high - low) - 2.0 * float_spacing(fill)) / (1.0 + 2.0 * kPlacementGap);
  if (radius <= 0.0) return 0.0;
  const double digit = std::pow(10.0, std::floor(std::log10(radius)) - 3.0);
  return std::floor(radius / digit) * digit;
}

/// `value` rounded to the 24 bits of a float by Veltkamp's method (Dekker 1971, doi 10.1007/BF01397083). Not by casts to float
/// and back: g++ 12 removes both casts when it vectorises them (-ftree-slp-vectorize).
double as_float(double value) {
  const double c = value * 0x20000001p0;
  return c - (c - value);
}

Vec3d as_float(const Vec3d& p) { return {as_float(p.x), as_float(p.y), as_float(p.z)}; }

/// The box for the centre of a sphere, ends included, except the upper end of a periodic axis.
struct CentreBox {
  Vec3d low;
  Vec3d high;
  bool periodic[3] = {false, false, false};

  bool contains(const Vec3d& p) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] < low[axis] || p[axis] > high[axis] || (periodic[axis] && p[axis] == high[axis])) return false;
    }
    return true;
  }
};

/// Throws UserError if the region is too small for a sphere of this radius.
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

/// Sites at low + (i, j, k) · spacing, in the order i, k, j: from the floor up.
struct Lattice {
  Vec3d low;
  double spacing;
  Vec3d sites{1.0};  ///< along each axis

  int64_t size() const { return static_cast<int64_t>(std::min(sites.x * sites.y * sites.z, 1e18)); }
  Vec3d site(int64_t index) const {
    const auto row = static_cast<int64_t>(sites.x), rows = static_cast<int64_t>(sites.z);
    return as_float(low + spacing * Vec3d(double(index % row), double(index / row / rows), double(index / row % rows)));
  }
};

/// As narrow as the largest sphere of the fill allows.
Lattice lattice_of(const Domain& domain, const Fill& fill) {
  const double radius = fill.radius_max;
  const CentreBox box = centre_box(domain, fill, radius);
  // Two units in the last place compensate for rounding two neighbours to float.
  const double ulp = float_spacing(fill);
  Lattice lattice{box.low + ulp, 2.0 * radius * (1.0 + 2.0 * kPlacementGap) + 2.0 * ulp};
  if (domain.dimensions == 2) lattice.low.z = 0.0;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const double room = box.high[axis] - box.low[axis] - 2.0 * ulp;
    // The last site of a periodic axis is the neighbour of the first.
    const double count = std::floor(room / lattice.spacing) + (box.periodic[axis] ? 0.0 : 1.0);
    lattice.sites[axis] = std::clamp(count, 0.0, double(kLargestCount));
  }
  return lattice;
}

/// The number of a fill's spheres, up to its count, for which a lattice has free sites beside the spheres in `index`.
int64_t free_sites(const Domain& domain, const Fill& fill, const SphereIndex& index) {
  const Lattice lattice = lattice_of(domain, fill);
  if (index.size() == 0) return std::min(lattice.size(), fill.count);
  int64_t free = 0;
  for (int64_t site = 0; site < lattice.size() && free < fill.count; ++site) {
    free += index.is_free(lattice.site(site), fill.radius_max, kPlacementGap);
  }
  return free;
}

/// The mean volume [m³] of the spheres of a fill, as a fraction of its region's; areas in the plane.
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

/// `placed` is empty if no placement was tried. The message suggests a lattice if it has room.
[[noreturn]] void fail_random(const Domain& domain, const Fill& fill, std::optional<int64_t> placed,
                              bool fits_lattice) {
  const double percent = std::round(1000.0 * volume_fraction(domain, fill)) / 10.0;
  const std::string only = placed ? fmt::format(", but only {} found room", *placed) : "";
  throw input_error(fill.place, fill.count_key,
                    fmt::format("{} spheres{}: they ask for {} % of their region, random placement reaches about {} %",
                                fill.count, only, number_text(percent), domain.dimensions == 2 ? 54 : 38),
                    fits_lattice ? "fewer or smaller spheres, a larger region, or arrangement = \"lattice\""
                                 : "fewer or smaller spheres, or a larger region");
}

/// A fill during its placement; its first body is `first`.
struct Placement {
  const Scene& scene;
  const Fill& fill;
  int64_t first;
  uint64_t position_seed;
  SphereIndex& index;
  Bodies& bodies;
  const std::vector<std::pair<int64_t, int64_t>>& fixed;  ///< first, end: bodies that are placed before random ones

  void set_position(int64_t i, const Vec3d& position) const {
    const auto k = static_cast<size_t>(i);
    bodies.position[k] = position;
    index.insert(static_cast<int32_t>(i), position, bodies.radius[k]);
  }
};

/// Draws radii, velocities and masses, in the order of the bodies, so they do not depend on the search for positions.
void draw_properties(const Placement& placement, Random& master) {
  const Fill& fill = placement.fill;
  Bodies& bodies = placement.bodies;
  Random radii(master.bits());
  Random directions(master.bits());
  for (int64_t i = placement.first; i < placement.first + fill.count; ++i) {
    const auto k = static_cast<size_t>(i);
    double radius = fill.radius_min;
    if (fill.radius_min < fill.radius_max) {
      radius = std::clamp(as_float(radii.uniform(fill.radius_min, fill.radius_max)), fill.radius_min, fill.radius_max);
    }
    bodies.radius[k] = radius;
    bodies.mass[k] = fill.mass.value_or(sphere_mass(radius, placement.scene.physics.density));
    if (fill.velocity) {
      bodies.velocity[k] = *fill.velocity;
    } else if (fill.speed > 0.0) {
      bodies.velocity[k] = directions.direction(placement.scene.domain.dimensions) * fill.speed;
    }
  }
}

/// Throws until a sphere of this radius has room; counts the throws down in `budget`. Returns false if it found no room.
bool throw_until_free(const Placement& placement, double radius, Random& random, int64_t& budget, Vec3d& position) {
  const Domain& domain = placement.scene.domain;
  const CentreBox box = centre_box(domain, placement.fill, radius);
  for (int attempt = 0; attempt < kAttemptsPerSphere && budget > 0; ++attempt, --budget) {
    position = as_float(random.uniform(box.low, box.high));
    if (box.contains(position) && placement.index.is_free(position, radius, kPlacementGap)) return true;
  }
  return false;
}

/// Whether the fill would fit as a lattice, beside the spheres before all fills and those of other lattices.
bool fits_lattice(const Placement& placement) {
  SphereIndex fixed(placement.scene.domain);
  for (const auto& [first, end] : placement.fixed) {
    for (int64_t i = first; i < end; ++i) {
      const auto k = static_cast<size_t>(i);
      fixed.insert(static_cast<int32_t>(i), placement.bodies.position[k], placement.bodies.radius[k]);
    }
  }
  return free_sites(placement.scene.domain, placement.fill, fixed) == placement.fill.count;
}

void place_at_random(const Placement& placement) {
  const Fill& fill = placement.fill;
  const std::vector<double>& radius = placement.bodies.radius;
  Random random(placement.position_seed);
  int64_t budget = 1'000'000 + 30 * fill.count, placed = 0;
  for (const int32_t i : by_descending_radius(radius, placement.first, placement.first + fill.count)) {
    Vec3d position(0.0);
    if (!throw_until_free(placement, radius[static_cast<size_t>(i)], random, budget, position)) {
      fail_random(placement.scene.domain, fill, placed, fits_lattice(placement));
    }
    placement.set_position(i, position);
    ++placed;
  }
}

[[noreturn]] void fail_lattice(const Fill& fill, int64_t fitting) {
  throw input_error(fill.place, fill.count_key, std::to_string(fill.count),
                    fmt::format("at most {}: no more fit on the lattice in this region", fitting));
}

void place_on_lattice(const Placement& placement) {
  const Fill& fill = placement.fill;
  const Lattice lattice = lattice_of(placement.scene.domain, fill);
  const bool alone = placement.index.size() == 0;
  int64_t site = 0;
  for (int64_t placed = 0; placed < fill.count; ++site) {
    if (site == lattice.size()) fail_lattice(fill, placed);
    const Vec3d position = lattice.site(site);
    const double radius = placement.bodies.radius[static_cast<size_t>(placement.first + placed)];
    if (!alone && !placement.index.is_free(position, radius, kPlacementGap)) continue;
    placement.set_position(placement.first + placed, position);
    ++placed;
  }
}

/// Lattices first, then by descending radius, else in the order of the file.
std::vector<size_t> placing_order(std::span<const Fill> fills) {
  std::vector<size_t> order(fills.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto rank = [](const Fill& fill) {
    return fill.arrangement == Arrangement::lattice ? std::numeric_limits<double>::infinity() : fill.radius_max;
  };
  std::stable_sort(order.begin(), order.end(), [&](size_t i, size_t j) { return rank(fills[i]) > rank(fills[j]); });
  return order;
}

/// Refuses a fill that cannot fit, before allocating memory for it.
void check_room(const Domain& domain, const Fill& fill, const SphereIndex& index) {
  if (fill.count == 0) return;
  if (fill.arrangement == Arrangement::lattice) {
    if (lattice_of(domain, fill).size() < fill.count) fail_lattice(fill, free_sites(domain, fill, index));
    return;
  }
  centre_box(domain, fill, fill.radius_max);
  // Random placement of many equal spheres, or discs, never exceeds saturation; with a margin for small boxes.
  const bool many_equal = fill.radius_min == fill.radius_max && fill.count >= 1000;
  const double saturation = domain.dimensions == 2 ? 0.56 : 0.40;
  if (volume_fraction(domain, fill) > (many_equal ? saturation : 1.0)) {
    fail_random(domain, fill, std::nullopt, free_sites(domain, fill, index) == fill.count);
  }
}

}  // namespace

void place_fills(const Scene& scene, std::span<const Fill> fills, SphereIndex& index, Bodies& bodies) {
  int64_t total = bodies.size();
  for (const Fill& fill : fills) {
    check_room(scene.domain, fill, index);
    total += fill.count;
  }
  Random master(scene.seed);
  std::vector<Placement> placements;
  int64_t first = bodies.size();
  std::vector<std::pair<int64_t, int64_t>> fixed{{0, first}};
  bodies.resize(total);
  for (const Fill& fill : fills) {
    placements.push_back({scene, fill, first, 0, index, bodies, fixed});
    if (fill.arrangement == Arrangement::lattice) fixed.emplace_back(first, first + fill.count);
    draw_properties(placements.back(), master);
    placements.back().position_seed = master.bits();
    first += fill.count;
  }
  for (const size_t k : placing_order(fills)) {
    (fills[k].arrangement == Arrangement::lattice ? place_on_lattice : place_at_random)(placements[k]);
  }
}

}  // namespace ballpit
