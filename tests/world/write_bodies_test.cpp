// SPDX-License-Identifier: MIT
// What a world writes for the vertex shader is what an inspection shows, and writing changes nothing.
#include <algorithm>

#include <catch2/catch.hpp>

#include "scene/read_scene.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

struct Written {
  std::vector<float> position, radius;
  std::vector<uint8_t> touching;
};

Written write(World& world) {
  const BodyShape shape = world.shape();
  Written written;
  written.position.assign(static_cast<size_t>(shape.count * shape.dimensions), -1);
  written.radius.assign(static_cast<size_t>(shape.has_equal_radii ? 0 : shape.count), -1);
  written.touching.assign(static_cast<size_t>(shape.count), 7);
  const auto span = [](auto& values) { return Span(values.data(), static_cast<int64_t>(values.size())); };
  world.write_bodies({span(written.position), span(written.radius), span(written.touching)});
  return written;
}

/// Compares; returns how many touch.
int check_written(World& world) {
  const Written written = write(world);
  const Inspection seen = world.inspect();
  CHECK(written.position == seen.bodies.position);
  const BodyShape shape = world.shape();
  CHECK(shape.count == seen.bodies.count);
  CHECK(shape.dimensions == seen.bodies.dimensions);
  CHECK(shape.radius == *std::max_element(seen.bodies.radius.begin(), seen.bodies.radius.end()));
  CHECK(shape.smallest == *std::min_element(seen.bodies.radius.begin(), seen.bodies.radius.end()));
  if (!shape.has_equal_radii) CHECK(written.radius == seen.bodies.radius);
  std::vector<uint8_t> touching(static_cast<size_t>(shape.count), 0);
  for (const Pair& pair : seen.contacts)
    touching[static_cast<size_t>(pair.i)] = touching[static_cast<size_t>(pair.j)] = 1;
  CHECK(written.touching == touching);
  return static_cast<int>(std::count(touching.begin(), touching.end(), 1));
}

}  // namespace

TEST_CASE("the bodies that a world writes are those that it shows") {
  const Cloud cloud = GENERATE(Cloud{.count = 150, .smallest = 0.1, .largest = 0.15},
                               Cloud{.count = 150, .smallest = 0.1, .largest = 0.1},
                               Cloud{.count = 100, .dimensions = 2, .smallest = 0.05, .largest = 0.05});
  const std::string precision = GENERATE("float", "double");
  Settings settings;
  settings.precision = named<Precision>(precision);
  const auto world = cpu_backend().make_world(make_cloud(cloud, 5), settings);
  CAPTURE(cloud.dimensions, cloud.largest, precision);
  CHECK(check_written(*world) > 10);
  const uint64_t state = world->report().state_hash;
  write(*world);
  CHECK(world->report().state_hash == state);
  for (int k = 0; k < 5; ++k) world->step();
  check_written(*world);
}

TEST_CASE("bodies that are sorted in memory are written in the order of their ids") {
  Settings settings;
  settings.broadphase = BroadPhase::sorted_grid;
  settings.threads = 2;
  const auto world =
      cpu_backend().make_world(make_cloud({.count = 5000, .smallest = 0.02, .largest = 0.04}, 5), settings);
  for (int k = 0; k < 2; ++k) world->step();
  CHECK(check_written(*world) > 100);
}

TEST_CASE("event-driven motion writes its bodies as well") {
  Settings settings;
  settings.response = Response::event_driven;
  const auto world = cpu_backend().make_world(load_scene("cradle", {}), settings);
  CHECK(check_written(*world) > 1);
}

TEST_CASE("an inspection without the state holds the number of bodies alone") {
  const auto world = cpu_backend().make_world(make_cloud({.count = 20, .smallest = 0.1, .largest = 0.1}, 5), {});
  const Inspection seen = world->inspect({.state = false});
  CHECK(seen.bodies.count == 20);
  CHECK(seen.bodies.position.empty());
  CHECK(seen.contacts.empty());
}
