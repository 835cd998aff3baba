// SPDX-License-Identifier: MIT
// Worlds on CUDA equal worlds on the CPU: the same contacts, the same bits of motion.
#include <catch2/catch.hpp>

#include "tests/simulate/scenes.h"

using namespace ballpit;

namespace {

struct Twins {
  std::unique_ptr<World> cpu, cuda;

  explicit Twins(const Scene& scene, const std::string& broadphase = "linked-cell") {
    Settings settings;
    settings.broadphase = broadphase;
    settings.dt = 1.0 / 480;
    cpu = cpu_backend().make_world(scene, settings);
    cuda = cuda_backend().make_world(scene, settings);
  }
};

Scene heap(const Cloud& cloud) {
  Scene scene = make_cloud(cloud, 5);
  scene.physics.gravity = {0, -9.81, 0};
  for (Vec3d& p : scene.bodies.position) p = glm::clamp(p, Vec3d(-0.9), Vec3d(0.9));
  if (cloud.dimensions == 2) {
    for (Vec3d& p : scene.bodies.position) p.z = 0;
  }
  return scene;
}

}  // namespace

TEST_CASE("CUDA finds the contacts that the CPU finds, by every broad phase") {
  const std::string broadphase = GENERATE("linked-cell", "brute-force");
  const Cloud cloud = GENERATE(Cloud{.count = 200, .smallest = 0.1, .largest = 0.1},
                               Cloud{.count = 200, .smallest = 0.02, .largest = 0.2},
                               Cloud{.count = 200, .dimensions = 2, .smallest = 0.05, .largest = 0.05},
                               Cloud{.count = 200, .smallest = 0.125, .largest = 0.125, .snap = 0.25},
                               Cloud{.count = 200, .smallest = 0.1, .largest = 0.1, .boundary = Boundary::periodic});
  const Twins worlds(make_cloud(cloud, 3), broadphase);
  const Inspection cpu = worlds.cpu->inspect(), cuda = worlds.cuda->inspect();
  REQUIRE(cpu.contacts.size() > 10);
  CHECK(cuda.contacts == cpu.contacts);
  CHECK(worlds.cuda->report().candidates == worlds.cpu->report().candidates);
}

TEST_CASE("the state on CUDA has the bits that it has on the CPU") {
  const Cloud cloud = GENERATE(Cloud{.count = 250, .smallest = 0.06, .largest = 0.1},
                               Cloud{.count = 120, .dimensions = 2, .smallest = 0.05, .largest = 0.05});
  const Twins worlds(heap(cloud));
  for (int k = 0; k < 12; ++k) {
    worlds.cpu->step();
    worlds.cuda->step();
  }
  const Report cpu = worlds.cpu->report(), cuda = worlds.cuda->report();
  CHECK(cuda.contacts > 10);
  CHECK(cuda.state_hash == cpu.state_hash);
  CHECK(cuda.kinetic_energy == cpu.kinetic_energy);
  CHECK(cuda.max_overlap == cpu.max_overlap);
}

TEST_CASE("worlds of zero, one and two spheres run on CUDA") {
  Scene scene;
  for (int n = 0; n <= 2; ++n) {
    const Twins worlds(scene);
    worlds.cpu->step();
    worlds.cuda->step();
    CHECK(worlds.cuda->report().state_hash == worlds.cpu->report().state_hash);
    add_sphere(scene, {0.4 + 0.09 * n, 0.5, 0.5}, {0.1, 0, 0});
  }
}
