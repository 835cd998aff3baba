// SPDX-License-Identifier: MIT
#include "measure/gas.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/random.h"

namespace ballpit {

namespace {

constexpr double kRadius = 0.01;  // [m]
constexpr double kMass = 0.004;   // [kg]

/// Sites of a cubic lattice with `side` sites along each edge, displaced at random.
std::vector<Vec3d> jittered_lattice(int64_t count, int64_t side, double spacing, Random& random) {
  const double jitter = spacing / 2 - kRadius;
  std::vector<Vec3d> places;
  places.reserve(static_cast<size_t>(count));
  for (int64_t k = 0; k < count; ++k) {
    const Vec3d cell(static_cast<double>(k % side), static_cast<double>(k / side % side),
                     static_cast<double>(k / (side * side)));
    places.push_back((cell + 0.5) * spacing + random.uniform(Vec3d(-jitter), Vec3d(jitter)));
  }
  return places;
}

/// Durstenfeld 1964, Algorithm 235.
void shuffle(std::vector<Vec3d>& places, Random& random) {
  for (size_t k = places.size(); k > 1; --k) {
    std::swap(places[k - 1], places[static_cast<size_t>(random.uniform() * static_cast<double>(k))]);
  }
}

}  // namespace

Scene make_gas(int64_t count, uint64_t seed) {
  Random random(seed);
  const double spacing = kRadius * std::cbrt(4.0 / 3 * std::numbers::pi / kGasVolumeFraction);
  const auto side = static_cast<int64_t>(std::ceil(std::cbrt(static_cast<double>(count)) - 1e-9));
  Scene scene;
  scene.name = "gas";
  scene.domain.max = Vec3d(static_cast<double>(side) * spacing);
  scene.physics.restitution = scene.physics.wall_restitution = 1.0;
  scene.bodies.position = jittered_lattice(count, side, spacing, random);
  shuffle(scene.bodies.position, random);
  for (int64_t k = 0; k < count; ++k) scene.bodies.velocity.push_back(random.uniform() * random.direction(3));
  scene.bodies.radius.assign(static_cast<size_t>(count), kRadius);
  scene.bodies.mass.assign(static_cast<size_t>(count), kMass);
  return scene;
}

}  // namespace ballpit
