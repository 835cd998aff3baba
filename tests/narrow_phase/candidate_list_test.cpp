// SPDX-License-Identifier: MIT
#include "narrow_phase/candidate_list.h"

#include <catch2/catch.hpp>

#include "broad_phase/grid.h"
#include "exec/cpu_executor.h"
#include "tests/support/body_arrays.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// A list with a skin of a tenth, started where the bodies are.
template <class V>
struct Started {
  BodyArrays<V> bodies;
  CpuExecutor exec{2};
  CandidateList<V, CpuExecutor> list;

  explicit Started(const Scene& scene, double skin = 0.1) : bodies(scene) {
    list.plan(skin, 2 * rounding_guard(bodies.box));
    list.start(exec, bodies.view(), bodies.box);
  }
  bool is_valid() {
    list.moved();
    return list.is_valid(exec, bodies.view(), bodies.box);
  }
  bool shows_all_inside() { return list.shows_all_inside(exec, bodies.view(), bodies.box); }
};

Scene cloud(double low = -1.0, double largest = 0.05) {
  return make_cloud({.count = 1000, .low = low, .high = low + 2, .smallest = 0.05, .largest = largest}, 1);
}

}  // namespace

TEST_CASE("a list is valid as long as every sphere is within its skin, and no longer") {
  for (const size_t body : {0, 500, 999}) {
    Started<Vec3> started(cloud());
    CHECK(started.is_valid());
    const Vec3 start = started.bodies.position[body];
    started.bodies.position[body] = start + Vec3(0.0f, 0.0049f, 0.0f);  // the skin is 0.005
    CHECK(started.is_valid());
    started.bodies.position[body] = start - Vec3(0.0049f, 0.0f, 0.0f);
    CHECK(started.is_valid());
    started.bodies.position[body] = start + Vec3(0.004f, 0.004f, 0.0f);
    CHECK_FALSE(started.is_valid());
    started.bodies.position[body] = start;
    CHECK_FALSE(started.is_valid());  // once invalid, it stays invalid
    started.list.start(started.exec, started.bodies.view(), started.bodies.box);
    CHECK(started.is_valid());
  }
}

TEST_CASE("a large sphere may move as far as its own skin, a small one less") {
  Scene scene = cloud();
  scene.bodies.radius[7] = 0.5;
  Started<Vec3> started(scene);
  started.bodies.position[7].x += 0.04f;
  CHECK(started.is_valid());
  started.bodies.position[8].x += 0.04f;
  CHECK_FALSE(started.is_valid());
}

TEST_CASE("a list is not valid before it is started, after it is discarded, or for another number of bodies") {
  Started<Vec3> started(cloud());
  started.list.discard();
  CHECK_FALSE(started.is_valid());
  started.list.start(started.exec, started.bodies.view(), started.bodies.box);
  CHECK(started.is_valid());
  started.bodies.position.pop_back();
  CHECK_FALSE(started.is_valid());
  CandidateList<Vec3, CpuExecutor> fresh;
  fresh.plan(0.1, 0);
  CHECK_FALSE(fresh.is_valid(started.exec, started.bodies.view(), started.bodies.box));
}

TEST_CASE("crossing a periodic border is a small move") {
  Scene scene = cloud();
  scene.domain.boundary = Boundary::periodic;
  scene.bodies.position[3] = {0.999, 0, 0};
  Started<Vec3> started(scene);
  started.bodies.position[3].x = -0.999f;
  CHECK(started.is_valid());
  started.bodies.position[3].x = -0.99f;
  CHECK_FALSE(started.is_valid());
}

TEST_CASE("where floats are as coarse as the skin, no list is valid") {
  CHECK(Started<Vec3>(cloud(10.0)).is_valid());
  CHECK_FALSE(Started<Vec3>(cloud(1e4)).is_valid());
}

TEST_CASE("spheres that are not a number have left their skins") {
  Started<Vec2> started(make_cloud({.count = 10, .dimensions = 2}, 1));
  started.bodies.position[4].x = std::nanf("");
  CHECK_FALSE(started.is_valid());
}

TEST_CASE("a list shows that all spheres are inside where no skin reaches out of the domain") {
  Scene scene = cloud();
  scene.domain.min = {-2, -2, -2};
  scene.domain.max = {2, 2, 2};
  CHECK(Started<Vec3>(scene).shows_all_inside());
  scene.bodies.position[5].y = 1.996;  // the skin is 0.005
  CHECK_FALSE(Started<Vec3>(scene).shows_all_inside());
  scene.domain.boundary = Boundary::open_top;
  CHECK(Started<Vec3>(scene).shows_all_inside());
  scene.bodies.position[6].x = -1.996;
  CHECK_FALSE(Started<Vec3>(scene).shows_all_inside());
}

TEST_CASE("a list is checked once for the same positions") {
  Started<Vec3> started(cloud());
  started.bodies.position[3].x += 0.1f;
  CHECK(started.list.is_valid(started.exec, started.bodies.view(), started.bodies.box));  // moved() was not called
  CHECK_FALSE(started.is_valid());
}

TEST_CASE("the search for a list sees radii with skins, one where all are equal") {
  Started<Vec3> equal(cloud()), unequal(cloud(-1.0, 0.1));
  const BodiesView<Vec3> grown = equal.list.grown(equal.exec, equal.bodies.view());
  CHECK(grown.radius.is_uniform());
  CHECK(grown.radius[3] == Approx(0.055));
  CHECK(grown.position.data() == equal.bodies.position.data());
  const BodiesView<Vec3> each = unequal.list.grown(unequal.exec, unequal.bodies.view());
  CHECK_FALSE(each.radius.is_uniform());
  for (int i = 0; i < 1000; ++i) CHECK(each.radius[i] == unequal.bodies.radius[static_cast<size_t>(i)] * 1.1f);
}

TEST_CASE("a skin of zero is no list") {
  CandidateList<Vec3, CpuExecutor> list;
  list.plan(0.0, 0.0);
  CHECK_FALSE(list.is_used());
  list.plan(0.1, 0.0);
  CHECK(list.is_used());
}
