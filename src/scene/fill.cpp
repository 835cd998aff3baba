// SPDX-License-Identifier: MIT
#include "scene/fill.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/random.h"
#include "scene/fill_room.h"

namespace ballpit {

namespace {

/// A volume fraction that random placement of many equal spheres, or discs, never exceeds; with a margin for small boxes.
double saturation(const Domain& domain) { return domain.dimensions == 2 ? 0.56 : 0.40; }

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

/// Whether the fill would fit as a lattice, beside the spheres that are placed before it: those before all fills, and those
/// of other lattices.
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
  std::stable_sort(order.begin(), order.end(), [&](size_t i, size_t j) {
    const bool lattice_i = fills[i].arrangement == Arrangement::lattice;
    const bool lattice_j = fills[j].arrangement == Arrangement::lattice;
    if (lattice_i != lattice_j) return lattice_i;
    return !lattice_i && fills[i].radius_max > fills[j].radius_max;
  });
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
  const bool many_equal = fill.radius_min == fill.radius_max && fill.count >= 1000;
  if (volume_fraction(domain, fill) > (many_equal ? saturation(domain) : 1.0)) {
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
