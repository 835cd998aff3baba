// SPDX-License-Identifier: MIT
#include "bed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "core/error.h"
#include "core/random.h"
#include "simulate/world.h"

namespace ballpit {

namespace {

constexpr std::array kBeds{
    BedInfo{"loose", "20 % of the volume, speeds up to 1 m/s: a moving gas, contacts are few and short"},
    BedInfo{"dense", "a heap at rest, shaken a little: about 60 % of the volume and six contacts a sphere"},
};

constexpr double kRadius = 0x1p-7;     // [m]
constexpr double kDensity = 1000;      // [kg/m³]
constexpr double kStiffness = 1e5;     // [N/m] a contact lasts π·√(m/2k) = 314 µs without damping
constexpr double kTimeStep = 6.25e-6;  // [s] a fiftieth of that
constexpr double kGravity = 9.81;      // [m/s²]
constexpr double kHeadroom = 0.125;    // [m] higher than 1 m/s carries a sphere: no program meets the lid

constexpr double kSettleStep = 1.0 / 1000;  // [s]
constexpr int kSettleSteps = 700;           // a heap of 100 000 spheres falls for half of that
constexpr double kRelaxRestitution = 0.1;   // springs come to rest soon
constexpr double kShake = 0.05;             // [m/s] highest speed

/// Rounded to a multiple of 2⁻¹⁰ m.
double coarse(double length) { return std::ceil(length * 0x1p10) * 0x1p-10; }

Vec3d rounded(const Vec3d& a) { return widen(narrow<Vec3>(a)); }

/// Spheres on a jittered cubic lattice that takes up `fraction` of its cube, shuffled; a box around it with headroom.
Scene lattice(int64_t count, double fraction, double speed, Random& random) {
  const double spacing = coarse(kRadius * std::cbrt(4.0 / 3 * std::numbers::pi / fraction));
  const double jitter = 0.99 * (spacing / 2 - kRadius);
  const auto side = static_cast<int64_t>(std::ceil(std::cbrt(static_cast<double>(count)) - 1e-9));
  const double width = static_cast<double>(side) * spacing;
  Scene scene;
  scene.domain.max = Vec3d(width, width + kHeadroom, width);
  scene.domain.boundary = Boundary::open_top;
  scene.physics.gravity = Vec3d(0, -kGravity, 0);
  scene.physics.stiffness = kStiffness;
  scene.physics.density = kDensity;
  scene.bodies.resize(count);
  for (int64_t k = 0; k < count; ++k) {
    const auto i = static_cast<size_t>(k);
    const Vec3d cell(static_cast<double>(k % side), static_cast<double>(k / (side * side)),
                     static_cast<double>(k / side % side));
    scene.bodies.position[i] = rounded((cell + 0.5) * spacing + random.uniform(Vec3d(-jitter), Vec3d(jitter)));
    scene.bodies.velocity[i] = rounded(speed * random.uniform() * random.direction(3));
    scene.bodies.radius[i] = kRadius;
    scene.bodies.mass[i] = kDensity * 4 / 3 * std::numbers::pi * std::pow(kRadius, 3);
  }
  for (size_t k = scene.bodies.position.size(); k > 1; --k) {  // Durstenfeld 1964, Algorithm 235
    std::swap(scene.bodies.position[k - 1],
              scene.bodies.position[static_cast<size_t>(random.uniform() * static_cast<double>(k))]);
  }
  return scene;
}

void set_restitution(Scene& scene, double restitution) {
  scene.physics.restitution = scene.physics.wall_restitution = restitution;
}

/// The scene's spheres after so many steps.
Bodies after(const Scene& scene, const Settings& settings, int64_t steps) {
  const std::unique_ptr<World> world = cpu_backend().make_world(scene, settings);
  for (int64_t k = 0; k < steps; ++k) world->step();
  return world->bodies();
}

/// Falls by the impulse response, whose steps may be long; then springs take the load.
void settle(Scene& scene, int64_t relax_steps) {
  Settings settings = bed_settings(kSettleStep);
  settings.response = "impulse";
  settings.integrator = "auto";
  settings.threads = 0;
  set_restitution(scene, 0);
  scene.bodies = after(scene, settings, kSettleSteps);
  std::fill(scene.bodies.velocity.begin(), scene.bodies.velocity.end(), Vec3d(0.0));
  settings = bed_settings(kTimeStep);
  settings.threads = 0;
  set_restitution(scene, kRelaxRestitution);
  if (relax_steps > 0) scene.bodies = after(scene, settings, relax_steps);
}

Scene loose_bed(int64_t count, Random& random) {
  Scene scene = lattice(count, 0.2, 1.0, random);
  set_restitution(scene, 0.9);
  return scene;
}

Scene dense_bed(int64_t count, int64_t relax_steps, Random& random) {
  Scene scene = lattice(count, 0.4, 0.2, random);
  settle(scene, relax_steps);
  for (Vec3d& v : scene.bodies.velocity) v = rounded(v + kShake * random.uniform() * random.direction(3));
  set_restitution(scene, 0.5);
  return scene;
}

}  // namespace

std::span<const BedInfo> beds() { return kBeds; }

Bed make_bed(std::string_view name, int64_t count, uint64_t seed, int64_t relax_steps) {
  Random random(seed);
  Bed bed{std::string(name), {}, kTimeStep};
  if (name == "loose") {
    bed.scene = loose_bed(count, random);
  } else if (name == "dense") {
    bed.scene = dense_bed(count, relax_steps, random);
  } else {
    throw UserError("--beds: found " + std::string(name) + ", allowed loose, dense");
  }
  bed.scene.name = name;
  return bed;
}

Settings bed_settings(double dt) {
  Settings settings;
  settings.broadphase = "auto";
  settings.response = "penalty";
  settings.integrator = "velocity-verlet";
  settings.backend = "cpu";
  settings.threads = 1;
  settings.dt = dt;
  return settings;
}

double damping_ratio(double restitution) {
  if (restitution <= 0) return 1;
  const double log = std::log(restitution);
  return -log / std::sqrt(std::numbers::pi * std::numbers::pi + log * log);
}

}  // namespace ballpit
