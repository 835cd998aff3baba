// SPDX-License-Identifier: MIT
// Time per step by stage against the number of spheres: a gas of equal elastic spheres at 30 % of the volume of a box
// that grows with them, started on a jittered lattice in shuffled order.
//
//     bench_step [THREADS]        a table on standard output; medians over blocks of steps
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <sys/resource.h>

#include "core/random.h"
#include "simulate/world.h"

using namespace ballpit;

namespace {

constexpr double kRadius = 0.01;  // [m]
constexpr double kVolumeFraction = 0.3;
constexpr double kStep = 1.0 / 960;  // [s]
constexpr int kBlocks = 5;

/// n spheres on a cubic lattice whose spacing gives the volume fraction, jittered as far as they cannot touch.
Scene jittered_lattice(int n) {
  Random random(1);
  const double spacing = kRadius * std::cbrt(4.0 / 3 * 3.14159265358979 / kVolumeFraction);
  const int side = static_cast<int>(std::ceil(std::cbrt(n)));
  const double jitter = spacing / 2 - kRadius;
  std::vector<Vec3d> places;
  for (int k = 0; k < n; ++k) {
    const Vec3d cell(k % side, k / side % side, k / (side * side));
    places.push_back((cell + 0.5) * spacing + random.uniform(Vec3d(-jitter), Vec3d(jitter)));
  }
  for (size_t k = places.size(); k > 1; --k) {
    std::swap(places[k - 1], places[static_cast<size_t>(random.uniform() * static_cast<double>(k))]);
  }
  Scene scene;
  scene.domain.max = Vec3d(side * spacing);
  scene.physics.restitution = scene.physics.wall_restitution = 1.0;
  scene.bodies.position = std::move(places);
  for (int k = 0; k < n; ++k) scene.bodies.velocity.push_back(random.uniform() * random.direction(3));
  scene.bodies.radius.assign(static_cast<size_t>(n), kRadius);
  scene.bodies.mass.assign(static_cast<size_t>(n), 0.004);
  return scene;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void measure(int n, const Settings& settings) {
  std::unique_ptr<World> world = cpu_backend().make_world(jittered_lattice(n), settings);
  const int steps = std::max(2, std::min(200, 2'000'000 / n));
  for (int k = 0; k < steps; ++k) world->step();  // warm-up, and until spheres collide
  const Report before = world->report();
  std::vector<double> blocks;
  for (int block = 0; block < kBlocks; ++block) {
    const auto start = std::chrono::steady_clock::now();
    for (int k = 0; k < steps; ++k) world->step();
    blocks.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps);
  }
  const Report after = world->report();
  std::printf("%9d spheres: %9.4f ms a step, %6.1f ns a sphere, %.2f contacts a sphere\n", n, 1e3 * median(blocks),
              1e9 * median(blocks) / n, double(after.contacts) / n);
  for (size_t k = 0; k < before.stages.size(); ++k) {
    const double seconds = after.stages[k].seconds - before.stages[k].seconds;
    if (seconds > 0.01 * (after.seconds - before.seconds)) {
      std::printf("          %-20s %9.4f ms\n", after.stages[k].name.c_str(), 1e3 * seconds / (kBlocks * steps));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  settings.threads = argc > 1 ? std::atoi(argv[1]) : 1;
  settings.dt = kStep;
  std::printf("GCC or compatible %s, %d thread(s), %.0f %% of the volume\n", __VERSION__, settings.threads,
              100 * kVolumeFraction);
  for (const int n : {1000, 10000, 100000, 1000000}) measure(n, settings);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("largest memory: %.0f MB\n", double(usage.ru_maxrss) / 1024);
}
