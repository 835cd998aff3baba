// SPDX-License-Identifier: MIT
// Acts on worlds of every response: what they change, what goes on, and the same bits however the world is computed.
#include "world/acts.h"

#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/support/kinds.h"

using namespace ballpit;

namespace {

/// A throw, a push and a drop in steps 5, 9 and 12; the last two in the same step.
std::vector<Act> some_acts(const Scene& scene, double dt) {
  const Bodies& bodies = scene.bodies;
  const double top = scene.domain.max.y - 0.15;
  Vec3d place(0.3 * scene.domain.max.x, top, scene.domain.dimensions == 2 ? 0 : 0.4 * scene.domain.max.z);
  return {
      {.time = 4.5 * dt, .sphere = 3, .vector = {1, 2, scene.domain.dimensions == 2 ? 0.0 : 0.5}},
      {.time = 9 * dt, .kind = ActKind::push, .sphere = 1, .vector = {0, 1.5, 0}, .reach = 0.3},
      {.time = 12 * dt, .kind = ActKind::drop, .sphere = bodies.size(), .vector = place, .radius = 0.01, .mass = 0.1},
      {.time = 12 * dt, .sphere = bodies.size(), .vector = {0, -1, 0}}};
}

/// Without spheres at the upper edge, so that there is room for one.
Scene crowd_below(int dimensions, int side, const Kind& kind, Boundary boundary) {
  Scene scene = crowd(dimensions, side, kind, boundary);
  scene.domain.max.y += 0.3;
  return scene;
}

struct Acted {
  std::unique_ptr<World> world;
  Acts acts;

  Acted(const Scene& scene, const Settings& settings, std::vector<Act> list)
      : world(make_cpu_world(scene, settings)), acts(scene.domain, std::move(list)) {
    acts.steps_by(settings.dt);
    acts.begin(*world);
  }
  uint64_t hash_after(int steps) {
    for (int k = 0; k < steps; ++k) acts.step(*world);
    return world->report().state_hash;
  }
};

}  // namespace

TEST_CASE("with acts, every response gives the same bits on any threads and broad phase, in both precisions") {
  int turn = 0;
  for (const Kind& kind : kinds()) {
    for (const char* const precision : {"float", "double"}) {
      const int dimensions = 2 + turn % 2;
      const Boundary boundary = turn / 2 % 2 == 0 ? Boundary::walls : Boundary::periodic;
      const Scene scene = crowd_below(dimensions, dimensions == 2 ? 8 : 4, kind, boundary);
      INFO(kind << ", " << precision << ", " << dimensions);
      std::optional<uint64_t> expected;
      for (int way = 0; way < 5; ++way) {  // broad phase and threads
        Settings settings = settings_of(kind, way);
        settings.precision = named<Precision>(precision);
        settings.skin = way == 2 ? 0.1 : 0;
        Acted acted(scene, settings, some_acts(scene, settings.dt));
        const uint64_t hash = acted.hash_after(40);
        CHECK(hash == expected.value_or(hash));
        expected = hash;
        CHECK(acted.world->shape().count == scene.bodies.size() + 1);
        CHECK(acted.world->steps() == 40);
        CHECK(acted.world->time() == Approx(40 * settings.dt));
      }
      ++turn;
    }
  }
}

TEST_CASE("an act changes what it says and nothing else") {
  for (const Kind& kind : kinds()) {
    const Scene scene = crowd_below(3, 4, kind, Boundary::walls);
    const Settings settings = settings_of(kind);
    Acted acted(scene, settings, {});
    acted.hash_after(7);
    const Bodies before = acted.world->bodies();
    acted.acts.add({.sphere = 5, .vector = {1, 2, 3}}, *acted.world);
    Bodies after = acted.world->bodies();
    INFO(kind);
    CHECK(after.velocity[5] == Vec3d(1, 2, 3));
    after.velocity[5] = before.velocity[5];
    CHECK(after.velocity == before.velocity);
    CHECK(after.position == before.position);
    CHECK(after.radius == before.radius);
    acted.acts.add({.kind = ActKind::push, .sphere = 5, .vector = {0, 1, 0}, .reach = 0.2}, *acted.world);
    const Bodies pushed = acted.world->bodies();
    int moved = 0;
    for (size_t i = 0; i < pushed.velocity.size(); ++i) {
      const bool is_near = length(before.position[i] - before.position[5]) <= 0.2;
      const Vec3d had = i == 5 ? Vec3d(1, 2, 3) : before.velocity[i];
      CHECK(pushed.velocity[i].y == Approx(had.y + (is_near ? 1 : 0)).margin(1e-6));
      moved += is_near;
    }
    CHECK(moved > 1);
    CHECK(moved < int(scene.bodies.size()));
    CHECK(acted.acts.all().size() == 2);
    CHECK(acted.acts.all()[1].time == acted.world->time());
  }
}

TEST_CASE("a push reaches over the edge of a periodic domain, and a drop has no room there") {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(1.0), Boundary::periodic, 3};
  for (const double x : {0.05, 0.95, 0.5}) add_sphere(scene, {x, 0.5, 0.5});
  Acted acted(scene, settings_of("impulse", 0.001), {});
  acted.acts.add({.kind = ActKind::push, .sphere = 0, .vector = {1, 0, 0}, .reach = 0.15}, *acted.world);
  const Bodies bodies = acted.world->bodies();
  CHECK(bodies.velocity[0].x == 1);
  CHECK(bodies.velocity[1].x == 1);
  CHECK(bodies.velocity[2].x == 0);
  const Act drop{.kind = ActKind::drop, .vector = {0.0, 0.55, 0.5}, .radius = 0.05, .mass = 1};
  CHECK_THROWS_WITH(
      acted.acts.add(drop, *acted.world),
      "drop at t = 0 s: no room for a sphere of radius 0.05 m at (0, 0.55, 0.5): sphere 0 is 0.029 m too near");
  CHECK(acted.acts.all().size() == 1);
  CHECK(acted.world->shape().count == 3);
}

TEST_CASE("an act belongs to the first step that ends at its time or later") {
  Scene scene;
  add_sphere(scene, Vec3d(0.5));
  for (const auto& [time, step] : {std::pair{0.0, 0}, {0.2, 2}, {0.3, 3}, {0.30001, 4}, {0.1 + 0.2, 3}, {0.7, 7}}) {
    Acted acted(scene, settings_of("impulse", 0.1), {{.time = time, .sphere = 0, .vector = {1e-3, 0, 0}}});
    int steps = 0;
    while (acted.world->bodies().velocity[0].x == 0) {
      acted.acts.step(*acted.world);
      REQUIRE(++steps < 20);
    }
    INFO(time);
    CHECK(steps == step);
    CHECK(acted.world->bodies().position[0].x == 0.5);  // at the end of the step
  }
}

TEST_CASE("contacts that last are not counted as new collisions after an act, and none is lost") {
  for (const char* const response : {"impulse", "penalty", "kinematic", "position-based"}) {
    Scene scene;
    scene.physics.gravity = {0, -9.81, 0};
    scene.physics.restitution = scene.physics.wall_restitution = 0.5;
    for (const double y : {0.05, 0.15, 0.9}) add_sphere(scene, {0.5, y, 0.5});
    Settings settings = settings_of(response, 1.0 / 480);
    settings.keeps_tally = true;
    Acted plain(scene, settings, {}), acted(scene, settings, {});
    for (int k = 0; k < 600; ++k) {
      plain.acts.step(*plain.world);
      acted.acts.step(*acted.world);
      const Bodies now = acted.world->bodies();
      if (k % 7 == 0) acted.acts.add({.sphere = 0, .vector = now.velocity[0]}, *acted.world);
    }
    INFO(response);
    const Tally &one = plain.world->report().tally, &other = acted.world->report().tally;
    CHECK(one.collisions > 0);
    CHECK(one.collisions == other.collisions);
    CHECK(one.wall_hits == other.wall_hits);
  }
}

TEST_CASE("the guard compares with the energy after the act, and names the time of the last good state") {
  Scene scene;
  add_sphere(scene, Vec3d(0.5));
  Acted acted(scene, settings_of("impulse", 1e-4), {});
  acted.hash_after(40);
  acted.acts.add({.sphere = 0, .vector = {50, 0, 0}}, *acted.world);
  CHECK_NOTHROW(acted.hash_after(40));
  acted.acts.add({.sphere = 0, .vector = {1e7, 0, 0}}, *acted.world);
  CHECK_THROWS_WITH(acted.hash_after(16), Catch::Contains("sphere 0 left the domain"));
  CHECK(acted.world->last_good_time() == Approx(80e-4));
  CHECK(acted.world->last_good().velocity[0].x == 1e7);
}

TEST_CASE("event-driven motion forecasts anew, and goes on counting") {
  Scene scene;
  for (const double x : {0.2, 0.8}) add_sphere(scene, {x, 0.5, 0.5}, {x < 0.5 ? 1.0 : -1.0, 0, 0});
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  Acted acted(scene, settings_of("event-driven", 0.01), {});
  acted.hash_after(40);
  CHECK(acted.world->report().tally.collisions == 1);
  const int64_t events = acted.world->report().events;
  acted.acts.add({.sphere = 0, .vector = {1, 0, 0}}, *acted.world);
  acted.acts.add({.sphere = 1, .vector = {-1, 0, 0}}, *acted.world);
  acted.hash_after(20);
  CHECK(acted.world->report().tally.collisions == 2);
  CHECK(acted.world->report().events > events);
  CHECK(acted.world->time() == Approx(0.6));
}

TEST_CASE("where there are no spheres, one can be dropped in, with every response") {
  for (const Kind& kind : kinds()) {
    Scene scene;
    scene.physics.gravity = {0, -9.81, 0};
    Acted acted(scene, settings_of(kind), {});
    acted.hash_after(3);
    acted.acts.add({.kind = ActKind::drop, .vector = Vec3d(0.5), .radius = 0.05, .mass = 1}, *acted.world);
    acted.hash_after(10);
    INFO(kind);
    CHECK(acted.world->bodies().position[0].y < 0.5);
    CHECK(acted.acts.all()[0].sphere == 0);
    CHECK_THROWS_WITH(acted.acts.add({.sphere = 1, .vector = Vec3d(1)}, *acted.world),
                      Catch::Contains("there is no sphere 1"));
  }
}
