// SPDX-License-Identifier: MIT
#include "bed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "world/world.h"

namespace ballpit {

namespace {

constexpr std::array kBeds{
    BedInfo{"loose", "20 % of the volume, speeds up to 1 m/s: a gas, contacts are few and short"},
    BedInfo{"dense", "a heap come to rest and shaken: 62 % of the volume, about six contacts a sphere"},
};

constexpr double kRadius = 0x1p-7;     // [m]
constexpr double kDensity = 1000;      // [kg/m³]
constexpr double kStiffness = 1e5;     // [N/m] a contact lasts π·√(m/2k) = 314 µs without damping
constexpr double kTimeStep = 6.25e-6;  // [s] a fiftieth of that
constexpr double kGravity = 9.81;      // [m/s²]
constexpr double kHeadroom = 0.125;    // [m] higher than a sphere with 1 m/s rises

constexpr double kRelaxRestitution = 0.1;  // springs come to rest soon
constexpr double kShake = 0.02;            // [m/s] highest speed

/// [m] between neighbours of a face-centred lattice whose spheres take up `fraction` of the volume: φ = √2·π/6·(2r/d)³.
/// Rounded to a multiple of 2⁻¹⁴ m, so that walls are exact.
double spacing_of(double fraction) {
  return std::round(2 * kRadius * std::cbrt(std::numbers::sqrt2 * std::numbers::pi / 6 / fraction) * 0x1p14) * 0x1p-14;
}

Vec3d rounded(const Vec3d& a) { return widen(narrow<Vec3>(a)); }

/// Durstenfeld 1964, Algorithm 235.
void shuffle(std::vector<Vec3d>& places, Random& random) {
  for (size_t k = places.size(); k > 1; --k) {
    std::swap(places[k - 1], places[static_cast<size_t>(random.uniform() * static_cast<double>(k))]);
  }
}

/// A face-centred lattice; spheres are displaced at random without touching.
struct Lattice {
  double fraction;  ///< of the volume, if all sites are taken
  double taken;     ///< share of the sites
  double speed;     ///< [m/s] at most
};

/// `count` sites, with a square of `side` sites in each layer; the layers reach half the width high.
std::vector<Vec3d> sites_of(int64_t count, int64_t side, double spacing) {
  std::vector<Vec3d> sites;
  for (int64_t k = 0; k < count; ++k) {
    const int64_t layer = k / (side * side);
    const double shift = layer % 2 == 0 ? 0.5 : 1.0;
    sites.emplace_back((static_cast<double>(k % side) + shift) * spacing,
                       (static_cast<double>(layer) / std::numbers::sqrt2 + 0.5) * spacing,
                       (static_cast<double>(k / side % side) + shift) * spacing);
  }
  return sites;
}

/// Spheres on a lattice, shuffled; a box around it with headroom.
Scene lattice_scene(int64_t count, const Lattice& lattice, Random& random) {
  const double spacing = spacing_of(lattice.fraction), jitter = 0.99 * (spacing / 2 - kRadius) / std::sqrt(3.0);
  const auto site_count = static_cast<int64_t>(std::ceil(static_cast<double>(count) / lattice.taken));
  const auto side =
      static_cast<int64_t>(std::ceil(std::cbrt(std::numbers::sqrt2 * static_cast<double>(site_count)) - 1e-9));
  std::vector<Vec3d> sites = sites_of(site_count, side, spacing);
  const double width = (static_cast<double>(side) + 0.5) * spacing;
  Scene scene;
  scene.domain.max = Vec3d(width, std::ceil((sites.back().y + spacing / 2) * 0x1p7) * 0x1p-7 + kHeadroom, width);
  scene.domain.boundary = Boundary::open_top;
  scene.physics.gravity = Vec3d(0, -kGravity, 0);
  scene.physics.stiffness = kStiffness;
  scene.physics.density = kDensity;
  shuffle(sites, random);
  scene.bodies.resize(count);
  for (size_t i = 0; i < scene.bodies.position.size(); ++i) {
    scene.bodies.position[i] = sites[i] + random.uniform(Vec3d(-jitter), Vec3d(jitter));
    scene.bodies.velocity[i] = lattice.speed * random.uniform() * random.direction(3);
    scene.bodies.radius[i] = kRadius;
    scene.bodies.mass[i] = kDensity * 4 / 3 * std::numbers::pi * std::pow(kRadius, 3);
  }
  return scene;
}

void set_restitution(Scene& scene, double restitution) {
  scene.physics.restitution = scene.physics.wall_restitution = restitution;
}

/// The spheres of the scene after this number of steps.
Bodies after(const Scene& scene, const Settings& settings, int64_t steps) {
  const std::unique_ptr<World> world = cpu_backend().make_world(scene, settings);
  for (int64_t k = 0; k < steps; ++k) world->step();
  return world->bodies();
}

/// Spheres that have moved until nothing is left of the lattice.
Scene loose_bed(int64_t count, int64_t steps, Random& random) {
  Scene scene = lattice_scene(count, {0.2, 1.0, 1.0}, random);
  set_restitution(scene, 0.9);
  scene.bodies = after(scene, bed_settings(kTimeStep), steps);
  return scene;
}

/// Spheres that have fallen by a hundredth of their height, come to rest, and been shaken.
Scene dense_bed(int64_t count, int64_t steps, Random& random) {
  Scene scene = lattice_scene(count, {0.73, 0.92, 0.0}, random);
  set_restitution(scene, kRelaxRestitution);
  scene.bodies = after(scene, bed_settings(kTimeStep), steps);
  for (Vec3d& v : scene.bodies.velocity) v += kShake * random.uniform() * random.direction(3);
  set_restitution(scene, 0.5);
  return scene;
}

}  // namespace

std::span<const BedInfo> beds() { return kBeds; }

Bed make_bed(std::string_view name, int64_t count, uint64_t seed, int64_t settle_steps) {
  Random random(seed);
  Bed bed{std::string(name), {}, kTimeStep};
  if (name == "loose") {
    bed.scene = loose_bed(count, settle_steps / 4, random);
  } else if (name == "dense") {
    bed.scene = dense_bed(count, settle_steps, random);
  } else {
    throw UserError("--beds", name, "loose, dense");
  }
  for (Vec3d& p : bed.scene.bodies.position) p = rounded(p);
  for (Vec3d& v : bed.scene.bodies.velocity) v = rounded(v);
  bed.scene.name = name;
  return bed;
}

Settings bed_settings(double dt) {
  Settings settings;
  settings.broadphase = BroadPhase::automatic;
  settings.response = Response::penalty;
  settings.integrator = Integrator::symplectic_euler;
  settings.backend = BackendName::cpu;
  settings.threads = 1;
  settings.dt = dt;
  return settings;
}

}  // namespace ballpit
