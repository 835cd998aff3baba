// SPDX-License-Identifier: MIT
// The counts of a collider; and a candidate list never changes the contacts of a step.
#include "narrow_phase/collider.h"

#include <catch2/catch.hpp>

#include "tests/support/body_arrays.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// Bodies that move through their box by themselves, whatever is in the way.
template <class V>
struct Stirred {
  BodyArrays<V> bodies;

  void step(float dt) {
    for (size_t i = 0; i < bodies.position.size(); ++i) {
      V& p = bodies.position[i];
      p = bodies.box.wrap(p + bodies.velocity[i] * dt);
      if (bodies.box.is_periodic()) continue;
      for (int axis = 0; axis < kDimensions<V>; ++axis) {  // reflected at all sides
        if (p[axis] < bodies.box.min[axis] || p[axis] > bodies.box.max[axis]) bodies.velocity[i][axis] *= -1;
        p[axis] = std::clamp(p[axis], bodies.box.min[axis], bodies.box.max[axis]);
      }
    }
  }
};

template <class V>
Collider<V, CpuExecutor> collider(const Way& way, const BodyArrays<V>& bodies) {
  const Settings settings = settings_of(way);
  Collider<V, CpuExecutor> collider;
  collider.plan({named<BroadPhase>(way.broadphase), ""}, bodies.parameters(settings), way.skin);
  return collider;
}

std::vector<Pair> listed(Span<const Pair> pairs) { return {pairs.begin(), pairs.end()}; }

/// Steps a scene and compares the contacts with and without a skin. Returns the number of searches with a skin.
template <class V>
int64_t compare_steps(const Scene& scene, const Way& way, int steps, float dt) {
  Stirred<V> stirred{BodyArrays<V>(scene)};
  CpuExecutor exec(way.threads);
  auto with = collider(way, stirred.bodies);
  Way bare = way;
  bare.skin = 0;
  auto without = collider(bare, stirred.bodies);
  for (int step = 0; step < steps; ++step) {
    with.moved();
    without.moved();
    with.pairs(exec, stirred.bodies.view());
    without.pairs(exec, stirred.bodies.view());
    INFO("step " << step);
    REQUIRE(difference(listed(with.pairs()), listed(without.pairs())) == "");
    REQUIRE(exec.download(with.rows().first()) == exec.download(without.rows().first()));
    stirred.step(dt);
  }
  CHECK(without.searches() == steps);
  return with.searches();
}

int64_t compare_steps(const Scene& scene, const Way& way, int steps, float dt) {
  return scene.domain.dimensions == 2 ? compare_steps<Vec2>(scene, way, steps, dt)
                                      : compare_steps<Vec3>(scene, way, steps, dt);
}

/// The pairs of a collider that look at no search: candidates of the last find().
int64_t candidates_by_hand(const Scene& scene, const Way& way) {
  const BodyArrays<Vec2> bodies(scene);
  CpuExecutor exec(way.threads);
  auto found = collider(way, bodies);
  found.pairs(exec, bodies.view());
  return found.tests(exec);
}

}  // namespace

TEST_CASE("with a skin the contacts are those without in every step, and few steps search", "[slow]") {
  const Cloud cloud = GENERATE(
      Cloud{.count = 700, .smallest = 0.07, .largest = 0.07},
      Cloud{.count = 700, .smallest = 0.02, .largest = 0.2, .is_log_uniform = true},
      Cloud{.count = 700, .dimensions = 2, .smallest = 0.03, .largest = 0.03},
      Cloud{.count = 700, .smallest = 0.07, .largest = 0.07, .boundary = Boundary::periodic},
      Cloud{.count = 300, .dimensions = 2, .smallest = 0.02, .largest = 0.1, .boundary = Boundary::periodic},
      Cloud{.count = 100, .smallest = 0.3, .largest = 0.3, .boundary = Boundary::periodic, .stretch = {0.6, 1, 0.5}});
  const double skin = GENERATE(0.1, 0.5);
  const Scene scene = make_cloud(cloud, 3);
  const float dt = static_cast<float>(cloud.smallest * 0.1 / 8);  // speeds are up to 1 m/s: at least 8 steps in a skin
  for (const char* const method : {"brute-force", "sort-and-sweep", "linked-cell", "sorted-grid"}) {
    INFO(method << ", skin " << skin << ", dimensions " << cloud.dimensions << ", largest " << cloud.largest);
    const int64_t searches = compare_steps(scene, {.broadphase = method, .skin = skin}, 200, dt);
    CHECK(searches > 1);
    CHECK(searches < (skin > 0.1 ? 10 : 40));
  }
  const int64_t searches =
      compare_steps(scene, {.broadphase = "sorted-grid", .table = "hashed", .threads = 2, .skin = skin}, 50, dt);
  CHECK(searches < 12);
}

TEST_CASE("spheres too fast for a skin are searched for in every step, and found") {
  const Scene scene = make_cloud({.count = 500, .smallest = 0.07, .largest = 0.07}, 3);
  CHECK(compare_steps(scene, {.broadphase = "sorted-grid", .skin = 0.1}, 100, 0.05f) == 100);
}

TEST_CASE("a skin that fails at once is tried again after a while") {
  Stirred<Vec3> stirred{BodyArrays<Vec3>(make_cloud({.count = 500, .smallest = 0.07, .largest = 0.07}, 3))};
  CpuExecutor exec(1);
  auto found = collider({.broadphase = "sorted-grid", .skin = 0.1}, stirred.bodies);
  for (int step = 0; step < 50; ++step) {
    found.moved();
    found.pairs(exec, stirred.bodies.view());
    stirred.step(0.05f);
  }
  CHECK(found.searches() == 50);
  for (int step = 0; step < 100; ++step) {  // all at rest
    found.moved();
    found.pairs(exec, stirred.bodies.view());
  }
  CHECK(found.searches() < 100);
}

TEST_CASE("a fast sphere expires the list, and is found where it went") {
  Scene scene;
  scene.domain.max = Vec3d(10.0);
  for (int k = 0; k < 20; ++k) add_sphere(scene, {0.5 + 0.45 * k, 1, 1}, Vec3d(0.0), 0.2);
  add_sphere(scene, {5, 9, 9}, Vec3d(0.0), 0.2);
  BodyArrays<Vec3> bodies(scene);
  for (const char* const method : {"brute-force", "sort-and-sweep", "linked-cell", "sorted-grid"}) {
    CpuExecutor exec(1);
    auto found = collider({.broadphase = method, .skin = 0.1}, bodies);
    const Vec3 start = bodies.position[20];
    for (int k = 0; k < 5; ++k) {
      found.moved();
      found.pairs(exec, bodies.view());
      CHECK(found.pairs().empty());
      bodies.position[20].x += 0.003f;
    }
    CHECK(found.searches() == 1);
    bodies.position[20] = bodies.position[4] + Vec3(0.0f, 0.3f, 0.0f);
    found.moved();
    found.pairs(exec, bodies.view());
    CHECK(found.searches() == 2);
    CHECK(listed(found.pairs()) == std::vector<Pair>{{4, 20}});
    bodies.position[20] = start;
  }
}

TEST_CASE("a discarded list is made anew, for bodies that are others now") {
  Scene scene = make_cloud({.count = 300, .smallest = 0.07, .largest = 0.07}, 3);
  BodyArrays<Vec3> bodies(scene);
  CpuExecutor exec(1);
  auto found = collider({.broadphase = "sorted-grid", .skin = 0.1}, bodies);
  found.pairs(exec, bodies.view());
  std::reverse(bodies.position.begin(), bodies.position.end());
  std::reverse(scene.bodies.position.begin(), scene.bodies.position.end());
  found.discard();
  found.pairs(exec, bodies.view());
  CHECK(found.searches() == 2);
  CHECK(difference(listed(found.pairs()), pairs_by_definition(scene)) == "");
}

TEST_CASE("candidates of each method on four spheres are those counted by hand") {
  //   y │ ·  C  ·  ·      A and B share a cell, C lies diagonally above them, D three cells to the right
  //     │ AB ·  ·  D      cells are one diameter wide, 1 m
  //     └─────────── x
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(4.0, 4.0, 0.0), Boundary::walls, 2};
  add_sphere(scene, {0.5, 0.5, 0}, Vec3d(0.0), 0.5);  // A
  add_sphere(scene, {0.9, 0.5, 0}, Vec3d(0.0), 0.5);  // B
  add_sphere(scene, {1.6, 1.6, 0}, Vec3d(0.0), 0.5);  // C
  add_sphere(scene, {3.5, 0.5, 0}, Vec3d(0.0), 0.5);  // D
  CHECK(candidates_by_hand(scene, {.broadphase = "brute-force"}) == 6);
  CHECK(candidates_by_hand(scene, {.broadphase = "sort-and-sweep", .axis = "x"}) == 2);                    // AB, BC
  CHECK(candidates_by_hand(scene, {.broadphase = "sort-and-sweep", .axis = "y"}) == 3);                    // AB, AD, BD
  CHECK(candidates_by_hand(scene, {.broadphase = "linked-cell", .table = "dense", .cell_size = 1}) == 3);  // AB, AC, BC
  CHECK(candidates_by_hand(scene, {.broadphase = "sorted-grid", .table = "dense", .cell_size = 1}) == 3);
  CHECK(candidates_by_hand(scene, {.broadphase = "linked-cell", .table = "hashed", .cell_size = 1}) == 3);
  CHECK(candidates_by_hand(scene, {.broadphase = "linked-cell", .table = "dense", .cell_size = 4}) == 6);
  CHECK(candidates_by_hand(scene, {.broadphase = "sorted-grid", .table = "dense", .cell_size = 4}) == 6);
  // With a skin of a tenth, the list of the pairs whose skins overlap: AB. (B and C are 1.3 m apart.)
  CHECK(candidates_by_hand(scene, {.broadphase = "brute-force", .skin = 0.1}) == 1);
  CHECK(candidates_by_hand(scene, {.broadphase = "linked-cell", .skin = 0.1}) == 1);
}

TEST_CASE("a collider reports its memory") {
  const BodyArrays<Vec3> bodies(make_cloud({.count = 1000}, 1));
  for (const char* const method : {"brute-force", "sort-and-sweep", "linked-cell", "sorted-grid"}) {
    for (const double skin : {0.0, 0.2}) {
      CpuExecutor exec(1);
      auto found = collider({.broadphase = method, .skin = skin}, bodies);
      found.pairs(exec, bodies.view());
      CHECK(found.bytes() > 8 * 1000);
      CHECK(found.bytes() < 1000 * 1000);
    }
  }
}
