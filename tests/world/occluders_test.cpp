// SPDX-License-Identifier: MIT
// The occluders of each sphere, against a search through all pairs.
#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// By the definition in world/occluders.h, with every pair looked at.
std::vector<Occluder> strongest(const BodySnapshot& bodies) {
  std::vector<Occluder> result;
  for (int64_t i = 0; i < bodies.count; ++i) {
    std::vector<std::pair<float, int>> found;  // minus the square root of the share, and the id
    for (int64_t j = 0; j < bodies.count; ++j) {
      const float own = bodies.radius_of(i), other = bodies.radius_of(j);
      const float distance = length(bodies.position_of(j) - bodies.position_of(i));
      if (j == i || !(distance < kOcclusionReach * (own + other))) continue;
      found.emplace_back(-other / std::max(distance - own, other), static_cast<int>(j));
    }
    std::sort(found.begin(), found.end());
    for (size_t k = 0; k < kOccluders; ++k) {
      if (k >= found.size()) {
        result.emplace_back();
      } else {
        const int64_t j = found[k].second;
        result.push_back({bodies.position_of(j) - bodies.position_of(i), bodies.radius_of(j)});
      }
    }
  }
  return result;
}

std::vector<Occluder> occluders_of(World& world) { return world.inspect({.occluders = true}).bodies.occluder; }

std::vector<Occluder> written(World& world) {
  const BodyShape shape = world.shape();
  std::vector<float> position(static_cast<size_t>(3 * shape.count)), radius(static_cast<size_t>(shape.count));
  std::vector<uint8_t> touching(static_cast<size_t>(shape.count));
  std::vector<Occluder> occluder(static_cast<size_t>(shape.count * kOccluders), {Vec3(7), 7});
  const auto span = [](auto& values) { return Span(values.data(), static_cast<int64_t>(values.size())); };
  BodyTarget target{span(position), {}, span(touching), span(occluder)};
  if (!shape.has_equal_radii) target.radius = span(radius);
  world.write_bodies(target);
  return occluder;
}

}  // namespace

TEST_CASE("the occluders are the neighbours that hide most of the sky") {
  const Cloud cloud = GENERATE(Cloud{.count = 300, .smallest = 0.1, .largest = 0.1},
                               Cloud{.count = 300, .smallest = 0.01, .largest = 0.2});
  const std::string response = GENERATE("impulse", "event-driven");
  const Boundary boundary = GENERATE(Boundary::walls, Boundary::periodic);
  CAPTURE(cloud.smallest, response, int(boundary));
  Scene scene = make_cloud(cloud, 5);
  scene.domain.boundary = boundary;
  if (response == "event-driven") {  // which refuses overlap
    for (double& radius : scene.bodies.radius) radius *= 0.02;
    for (Vec3d& place : scene.bodies.position) place *= 0.25;
    scene.domain.max *= 0.25;
  }
  Settings settings;
  settings.response = named<Response>(response);
  const auto world = cpu_backend().make_world(scene, settings);
  const BodySnapshot bodies = world->inspect().bodies;
  const std::vector<Occluder> expected = strongest(bodies);
  CHECK(std::count(expected.begin(), expected.end(), Occluder()) < std::ssize(expected));
  CHECK(occluders_of(*world) == expected);
  CHECK(written(*world) == expected);
}

TEST_CASE("occluders depend on nothing but the positions, and finding them changes nothing") {
  const Scene scene = make_cloud({.count = 400, .smallest = 0.05, .largest = 0.1}, 3);
  std::vector<std::vector<Occluder>> found;
  for (const int threads : {1, 3}) {
    for (const BroadPhase method : {BroadPhase::brute_force, BroadPhase::linked_cell}) {
      Settings settings;
      settings.threads = threads;
      settings.broadphase = method;
      const auto looked = cpu_backend().make_world(scene, settings), alone = cpu_backend().make_world(scene, settings);
      for (int step = 0; step < 70; ++step) {  // beyond a sorting of the bodies in memory
        looked->step();
        alone->step();
        if (step % 10 == 0) occluders_of(*looked);
      }
      CHECK(looked->report().state_hash == alone->report().state_hash);
      CHECK(looked->report().candidates == alone->report().candidates);
      found.push_back(occluders_of(*looked));
      CHECK(found.back() == strongest(looked->inspect().bodies));
    }
  }
  for (const auto& each : found) CHECK(each == found.front());
}

TEST_CASE("a sphere alone has no occluders, and no spheres have none") {
  Scene scene;
  Settings settings;
  CHECK(occluders_of(*cpu_backend().make_world(scene, settings)).empty());
  add_sphere(scene, {0.5, 0.5, 0.5}, {0, 0, 0}, 0.1);
  CHECK(occluders_of(*cpu_backend().make_world(scene, settings)) == std::vector<Occluder>(kOccluders));
}
