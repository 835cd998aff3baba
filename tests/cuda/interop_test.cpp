// SPDX-License-Identifier: MIT
// CUDA writes the bodies into OpenGL's buffers; where it may not, that is said once, and nothing is left behind.
#include <cstring>

#include <catch2/catch.hpp>

#include "render/body_buffer.h"
#include "render/gl_context.h"
#include "tests/cuda/fault_injection.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

std::unique_ptr<World> world_of(const Cloud& cloud, const Backend& backend = cuda_backend()) {
  Settings settings;
  settings.broadphase = BroadPhase::sorted_grid;
  settings.dt = 1.0 / 480;
  return backend.make_world(make_cloud(cloud, 5), settings);
}

bool are_same(const std::vector<Occluders>& a, const std::vector<Occluders>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Occluders)) == 0;
}

template <class T>
std::vector<T> stored(GLuint buffer, size_t n) {
  std::vector<T> values(n);
  glGetNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(n * sizeof(T)), values.data());
  return values;
}

/// Worlds in space are written with their occluders.
bool has_occluders(const World& world) { return world.shape().dimensions == 3; }

/// Whether OpenGL can draw on the device that computes; where it cannot, the writer has to say so.
bool can_share(BodyWriter& writer, World& world, BodyBuffer& buffer) {
  if (writer.write(world, buffer, has_occluders(world))) return true;
  WARN("not shared here: " << writer.trouble());
  CHECK_FALSE(writer.trouble().empty());
  return false;
}

void check_stored(World& world, const BodyBuffer& buffer) {
  const Inspection seen = world.inspect({.occluders = has_occluders(world)});
  CHECK(stored<float>(buffer.position_buffer(), seen.bodies.position.size()) == seen.bodies.position);
  const auto count = static_cast<size_t>(seen.bodies.count);
  CHECK(stored<Mark>(buffer.mark_buffer(), count) == contact_marks(seen.bodies.count, seen.contacts));
  if (!world.shape().has_equal_radii) CHECK(stored<float>(buffer.radius_buffer(), count) == seen.bodies.radius);
  if (has_occluders(world)) {
    CHECK(are_same(stored<Occluders>(buffer.occluder_buffer(), count), seen.bodies.occluders));
  }
  check_gl("reading what CUDA wrote");
}

}  // namespace

TEST_CASE("CUDA writes into OpenGL's buffers what an inspection shows") {
  const GlContext context(0);
  BodyBuffer buffer;
  const auto writer = make_cuda_body_writer();
  // The second and third take other buffers, the last one those of the third.
  for (const Cloud& cloud :
       {Cloud{.count = 100, .smallest = 0.1, .largest = 0.1}, Cloud{.count = 150, .smallest = 0.1, .largest = 0.15},
        Cloud{.count = 200, .dimensions = 2, .smallest = 0.03, .largest = 0.05},
        Cloud{.count = 90, .dimensions = 2, .smallest = 0.03, .largest = 0.05}}) {
    const auto world = world_of(cloud);
    if (!can_share(*writer, *world, buffer)) return;
    check_stored(*world, buffer);
    world->step();
    REQUIRE(writer->write(*world, buffer, has_occluders(*world)));
    check_stored(*world, buffer);
  }
}

TEST_CASE("CUDA finds the occluders that the CPU finds, to the bit") {
  for (const Cloud& cloud : {Cloud{.count = 400, .smallest = 0.1, .largest = 0.1},
                             Cloud{.count = 5000, .smallest = 0.01, .largest = 0.06}}) {
    const auto on_cuda = world_of(cloud), on_cpu = world_of(cloud, cpu_backend());
    for (World* const world : {on_cuda.get(), on_cpu.get()}) world->step();
    const Wanted wanted{.occluders = true};
    CHECK(are_same(on_cuda->inspect(wanted).bodies.occluders, on_cpu->inspect(wanted).bodies.occluders));
  }
}

TEST_CASE("bodies sorted in the device's memory are drawn in the order of their ids") {
  const GlContext context(0);
  BodyBuffer buffer;
  const auto writer = make_cuda_body_writer();
  const auto world = world_of({.count = 5000, .smallest = 0.02, .largest = 0.04});
  world->step();
  if (can_share(*writer, *world, buffer)) check_stored(*world, buffer);
}

TEST_CASE(
    "no sphere crosses the bus in a frame that CUDA writes, with occluders or without, also in steps that are "
    "checked") {
  const GlContext context(0);
  for (const double largest : {0.02, 0.04}) {
    const auto world = world_of({.count = 5000, .smallest = 0.02, .largest = largest});
    BodyBuffer buffer;
    const auto writer = make_cuda_body_writer();
    if (!can_share(*writer, *world, buffer)) return;
    for (int k = 0; k < 17; ++k) {
      faults::fail_at(0);
      world->step();
      REQUIRE(writer->write(*world, buffer, k % 2 == 0));
      CAPTURE(k, largest);
      CHECK(faults::bytes_to_host() < 256);  // counts, sums and flags
    }
  }
}

TEST_CASE("a device that may not share OpenGL's buffers says so once, and the world goes on") {
  const GlContext context(0);
  BodyBuffer buffer;
  const auto world = world_of({.count = 100, .smallest = 0.1, .largest = 0.1});
  const std::string call = GENERATE("cudaGLGetDevices", "cudaGraphicsGLRegisterBuffer");
  const auto writer = make_cuda_body_writer();
  faults::fail_always(call);
  CHECK_FALSE(writer->write(*world, buffer, has_occluders(*world)));
  CHECK_THAT(writer->trouble(), Catch::Contains(call) && Catch::Contains("unknown error"));
  faults::fail_at(0);
  CHECK_FALSE(writer->write(*world, buffer, has_occluders(*world)));  // not tried again
  CHECK(faults::calls().count(call) == 0);
  world->step();
  CHECK(world->report().steps == 1);
}

TEST_CASE("buffers that cannot be mapped are a failure of the run") {
  const GlContext context(0);
  BodyBuffer buffer;
  const auto world = world_of({.count = 100, .smallest = 0.1, .largest = 0.1});
  const auto writer = make_cuda_body_writer();
  if (!can_share(*writer, *world, buffer)) return;
  faults::fail_always("cudaGraphicsMapResources");
  CHECK_THROWS_WITH(writer->write(*world, buffer, has_occluders(*world)), Catch::Contains("cudaGraphicsMapResources"));
  faults::fail_at(0);
  REQUIRE(writer->write(*world, buffer, has_occluders(*world)));
  check_stored(*world, buffer);
}
