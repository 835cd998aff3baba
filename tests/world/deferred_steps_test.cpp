// SPDX-License-Identifier: MIT
// Steps that a host does not wait for, on a device that is none (ledger_executor.h): their bits, their kernels, and the
// bytes that these touch.
#include "world/deferred_steps.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/support/ledger_executor.h"
#include "tests/support/scenes.h"
#include "world/force_motion.h"
#include "world/impulse_motion.h"
#include "world/kinematic_motion.h"
#include "world/position_motion.h"
#include "world/world_on.h"

using namespace ballpit;

namespace {

Settings deferred_settings(const std::string& response, double skin = 0) {
  Settings settings;
  settings.response = named<Response>(response);
  settings.broadphase = BroadPhase::sorted_grid;
  settings.skin = skin;
  settings.dt = 1.0 / 480;
  settings.threads = 1;
  return settings;
}

/// A world on the device that is none, and what it launches.
struct Device {
  std::unique_ptr<World> world;
  ledger::Executor* exec;

  Device(const Scene& scene, const Settings& settings) {
    auto own = std::make_unique<ledger::Executor>();
    exec = own.get();
    world = scene.domain.dimensions == 2 ? make_world_of<Vec2>(std::move(own), scene, settings)
                                         : make_world_of<Vec3>(std::move(own), scene, settings);
  }
};

/// Spheres on a lattice that touch their six neighbours, or none.
Scene lattice(int side, double radius, double pitch) {
  Scene scene;
  scene.domain.min = Vec3d(0.0);
  scene.domain.max = Vec3d(side * pitch);
  scene.physics.gravity = {0, -9.81, 0};
  for (int k = 0; k < side * side * side; ++k) {
    scene.bodies.position.push_back(pitch * (Vec3d(k % side, k / side % side, k / side / side) + 0.5));
    scene.bodies.velocity.emplace_back(0.0);
    scene.bodies.radius.push_back(radius);
    scene.bodies.mass.push_back(1);
  }
  return scene;
}

struct StepCost {
  int64_t kernels = 0, bytes = 0;
  double contacts = 0;  // of a sphere
  std::string table;    // each launch: kernels, bytes of a sphere
};

/// Of a step that is deferred.
StepCost cost_of_step(const Scene& scene, const Settings& settings) {
  Device device(scene, settings);
  for (int k = 0; k < 4; ++k) device.world->step();
  const Report report = device.world->report();
  device.world->step();  // its contacts were found for the report
  device.exec->launches.clear();
  device.exec->waits = 0;
  device.world->step();
  CHECK(device.exec->waits == 0);
  StepCost cost;
  cost.contacts = double(report.contacts) / double(report.count);
  for (const ledger::Launch& launch : device.exec->launches) {
    cost.kernels += launch.kernels;
    cost.bytes += launch.bytes;
    cost.table +=
        fmt::format("{:30} {:2} {:8.1f}\n", launch.name, launch.kernels, double(launch.bytes) / double(report.count));
  }
  return cost;
}

}  // namespace

TEST_CASE("steps that are not waited for have the bits of the CPU's, by every response, with a skin and without") {
  for (const int dimensions : {2, 3}) {
    for (const char* response : {"impulse", "kinematic", "penalty", "position-based"}) {
      for (const double skin : {0.0, 0.3}) {
        const Scene scene = make_crowd(dimensions, 6, Boundary::walls, 0.5, 0.05, 0.068);
        const Settings settings = deferred_settings(response, skin);
        Device device(scene, settings);
        const auto cpu = cpu_backend().make_world(scene, settings);
        CAPTURE(dimensions, response, skin);
        for (int k = 0; k < 40; ++k) {
          device.world->step();
          cpu->step();
        }
        const Report expected = cpu->report(), report = device.world->report();
        CHECK(report.state_hash == expected.state_hash);
        CHECK(report.searches == expected.searches);
        CHECK(report.contacts == expected.contacts);
        if (settings.response != Response::kinematic) CHECK(report.contacts > 0);
      }
    }
  }
}

TEST_CASE("steps with more contacts than there is room for are repeated with more room, and have the same bits") {
  // From the start, and from the guard's 16th step
  const auto [speed, steps] = GENERATE(table<double, int>({{8, 14}, {4, 28}}));
  Scene scene = lattice(9, 0.05, 0.11);
  for (size_t i = 0; i < scene.bodies.position.size(); ++i) {
    scene.bodies.velocity[i] = speed * (scene.domain.max / 2.0 - scene.bodies.position[i]);
  }
  for (const char* response : {"impulse", "kinematic", "penalty", "position-based"}) {
    const Settings settings = deferred_settings(response);
    Device device(scene, settings);
    const auto cpu = cpu_backend().make_world(scene, settings);
    for (int k = 0; k < steps; ++k) {
      device.world->step();
      cpu->step();
    }
    const Report expected = cpu->report(), report = device.world->report();
    CAPTURE(speed, response);
    CHECK(device.exec->halts == 1);
    CHECK(report.steps == steps);
    CHECK(report.state_hash == expected.state_hash);
    CHECK(report.searches == expected.searches);
  }
}

TEST_CASE("position-based steps that are repeated count substeps from where they go back to") {
  const int halted_after = GENERATE(7, 20);
  const Scene scene = lattice(6, 0.06, 0.11);  // the longer it runs, the faster overlap of the start may be removed
  const Settings settings = deferred_settings("position-based");
  Device device(scene, settings);
  const auto cpu = cpu_backend().make_world(scene, settings);
  for (int k = 1; k <= 30; ++k) {
    device.world->step();
    if (k == halted_after) device.exec->raise_halt();
    cpu->step();
  }
  CHECK(device.world->report().state_hash == cpu->report().state_hash);
  CHECK(device.exec->halts == 1);
}

TEST_CASE("a sphere that leaves the domain in a step that is not waited for ends the run there, as on the CPU") {
  Scene scene;
  scene.physics.stiffness = 1;
  scene.bodies = {{{0.5, 0.5, 0.5}}, {{12, 0, 0}}, {0.1}, {1}};
  const Settings settings = deferred_settings("penalty");
  const auto message = [](World& world) -> std::string {
    try {
      for (int k = 0; k < 30; ++k) world.step();
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  };
  Device device(scene, settings);
  const auto cpu = cpu_backend().make_world(scene, settings);
  const std::string expected = message(*cpu);
  CHECK_THAT(expected, Catch::Contains("left the domain"));
  CHECK(cpu->steps() % 16 > 2);
  CHECK(message(*device.world) == expected);
  CHECK(device.world->steps() == cpu->steps());
  CHECK(device.world->report().state_hash == cpu->report().state_hash);
}

/// Bytes of a sphere, with m contacts: at most 560 + 390·m.
TEST_CASE("an impulse step takes at most 20 kernels, and few bytes") {
  constexpr int kSide = 40;
  constexpr double kSpheres = kSide * kSide * kSide;
  for (const double radius : {0.4, 0.501}) {
    const StepCost cost = cost_of_step(lattice(kSide, radius, 1), deferred_settings("impulse"));
    CAPTURE(cost.table, cost.contacts);
    CHECK(cost.contacts == Approx(radius > 0.5 ? 2.925 : 0));
    CHECK(cost.kernels <= 20);
    CHECK(double(cost.bytes) / kSpheres <= 560 + 390 * cost.contacts);
  }
}

TEST_CASE("a step by springs takes at most 22 kernels, and one by positions 21, whatever the number of colours") {
  for (const auto& [response, kernels] : {std::pair{"penalty", 22}, std::pair{"position-based", 21}}) {
    const StepCost cost = cost_of_step(lattice(17, 0.501, 1), deferred_settings(response));
    CAPTURE(cost.table);
    CHECK(cost.kernels <= kernels);
  }
}
