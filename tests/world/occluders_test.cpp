// SPDX-License-Identifier: MIT
// The occluders of each sphere, against a search through all pairs.
#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

std::vector<Occluders> occluders_of(World& world) { return world.inspect({.occluders = true}).bodies.occluders; }

std::vector<Occluders> written(World& world) {
  const BodyShape shape = world.shape();
  std::vector<float> position(static_cast<size_t>(3 * shape.count)), radius(static_cast<size_t>(shape.count));
  std::vector<uint8_t> touching(static_cast<size_t>(shape.count));
  std::vector<Occluders> occluders(static_cast<size_t>(shape.count));
  const auto span = [](auto& values) { return Span(values.data(), static_cast<int64_t>(values.size())); };
  BodyTarget target{span(position), {}, span(touching), span(occluders)};
  if (!shape.has_equal_radii) target.radius = span(radius);
  world.write_bodies(target);
  return occluders;
}

/// Sums may differ by rounding, since their order is free.
bool are_same(const std::vector<Occluders>& a, const std::vector<Occluders>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Occluders& one, const Occluders& other) {
    return std::ranges::equal(one.strongest, other.strongest) && std::abs(one.others - other.others) < 1e-5f &&
           length(one.others_by_normal - other.others_by_normal) < 1e-5f;
  });
}

}  // namespace

TEST_CASE("the occluders are the neighbours that hide most of the sky") {
  const std::string response = GENERATE("impulse", "event-driven");
  const Boundary boundary = GENERATE(Boundary::walls, Boundary::periodic);
  const double smallest = GENERATE(0.01, 0.1);
  CAPTURE(response, int(boundary), smallest);
  Scene scene = make_cloud({.count = 300, .smallest = smallest, .largest = smallest > 0.05 ? smallest : 0.2}, 5);
  if (response == "event-driven") scene = make_crowd(3, 6, boundary, 1, smallest > 0.05 ? 0.055 : 0.03, 0.055);
  scene.domain.boundary = boundary;
  Settings settings;
  settings.response = named<Response>(response);
  const auto world = cpu_backend().make_world(scene, settings);
  const BodySnapshot bodies = world->inspect().bodies;
  const std::vector<Occluders> expected = all_occluders(bodies);
  CHECK(std::ranges::any_of(expected, [](const Occluders& own) { return own.others > 0; }));
  CHECK(are_same(occluders_of(*world), expected));
  CHECK(are_same(written(*world), expected));
}

TEST_CASE("occluders depend on nothing but the positions, and finding them changes nothing") {
  const Scene scene = make_cloud({.count = 400, .smallest = 0.05, .largest = 0.1}, 3);
  std::vector<std::vector<Occluders>> found;
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
      CHECK(are_same(found.back(), all_occluders(looked->inspect().bodies)));
    }
  }
  for (const auto& each : found) CHECK(are_same(each, found.front()));
}

TEST_CASE("a sphere alone has no occluders, and no spheres have none") {
  Scene scene;
  Settings settings;
  CHECK(occluders_of(*cpu_backend().make_world(scene, settings)).empty());
  add_sphere(scene, {0.5, 0.5, 0.5}, {0, 0, 0}, 0.1);
  CHECK(are_same(occluders_of(*cpu_backend().make_world(scene, settings)), std::vector<Occluders>(1)));
}
