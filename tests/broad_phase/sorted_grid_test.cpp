// SPDX-License-Identifier: MIT
#include "broad_phase/sorted_grid.h"

#include <catch2/catch.hpp>

#include "tests/support/body_arrays.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// The grids of a sorted grid over a scene's bodies.
std::vector<GridInspection> grids_of(const Scene& scene, const Settings& settings = {}) {
  const BodyArrays<Vec3> bodies(scene);
  CpuExecutor exec(1);
  SortedGrid<Vec3, CpuExecutor> grid(bodies.parameters(settings));
  grid.prepare(exec, bodies.view());
  return grid.inspect(exec);
}

std::vector<int> bodies_in(const GridInspection& grid) {
  std::vector<int> bodies;
  for (int body : grid.head) {
    for (; body != -1; body = grid.next[static_cast<size_t>(body)]) bodies.push_back(body);
  }
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

}  // namespace

TEST_CASE("slots follow the cells, and within a cell the bodies") {
  const BodyArrays<Vec3> bodies(make_cloud({.count = 500, .smallest = 0.1, .largest = 0.1}, 4));
  CpuExecutor exec(2);
  SortedGrid<Vec3, CpuExecutor> grid(bodies.parameters({}));
  grid.prepare(exec, bodies.view());
  const auto candidates = grid.candidates();
  const auto key = [&](int slot) {
    return BucketOfBody<Vec3>{candidates.grids, bodies.view().position,
                              bodies.view().radius}(candidates.slots().body[slot]);
  };
  for (int slot = 0; slot < 500; ++slot) {
    const int body = candidates.slots().body[slot];
    CHECK(candidates.slots().position(slot) == bodies.position[static_cast<size_t>(body)]);
    CHECK((candidates.offsets[key(slot)] <= slot && slot < candidates.offsets[key(slot) + 1]));
    if (slot > 0)
      CHECK((key(slot - 1) < key(slot) || (key(slot - 1) == key(slot) && candidates.slots().body[slot - 1] < body)));
  }
}

TEST_CASE("cells are a diameter long, and so wide that three in a row hold about ten spheres") {
  for (const double radius : {0.02, 0.05, 0.1}) {
    const Scene scene = make_cloud({.count = 3000, .smallest = radius, .largest = radius}, 4);
    const BodyArrays<Vec3> bodies(scene);
    auto parameters = bodies.parameters({});
    parameters.occupied_volume = 8;
    const auto grid = SortedGrid<Vec3, CpuExecutor>(parameters).candidates().grids.grid[0];
    CHECK(grid.edge.x == Approx(2 * radius).epsilon(1e-4));
    CHECK(grid.edge.y == grid.edge.z);
    CHECK(grid.edge.y >= 2 * radius);
    if (radius < 0.1) CHECK(3000 / 8.0 * 3 * grid.edge.x * grid.edge.y * grid.edge.z == Approx(10).epsilon(1e-3));
  }
}

TEST_CASE("a body visits the rows that its sphere reaches, and of the others nothing") {
  // Three rows of spheres in a plane, far apart, and cells as wide as their distance.
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(4.0, 3.0, 0.0), Boundary::walls, 2};
  for (const double y : {0.5, 1.1, 2.1}) {
    for (int k = 0; k < 4; ++k) add_sphere(scene, {0.5 + k, y, 0}, Vec3d(0.0), 0.2);
  }
  const BodyArrays<Vec2> bodies(scene);
  CpuExecutor exec(1);
  auto parameters = bodies.parameters({});
  parameters.occupied_volume = 12 * 3 * 0.4 / 10;  // rows of width 1
  SortedGrid<Vec2, CpuExecutor> grid(parameters);
  grid.prepare(exec, bodies.view());
  const auto candidates = grid.candidates();
  REQUIRE(candidates.grids.grid[0].edge.y == Approx(1).epsilon(1e-4));
  const auto rows_visited = [&](int slot) {
    int rows = 0;
    candidates.for_each_range(slot, [&](const SlotRange& range) { rows += range.size() > 0; });
    return rows;
  };
  CHECK(rows_visited(0) == 0);  // at 0.5, with a diameter of 0.4, it stays below 1
  CHECK(rows_visited(4) == 0);  // at 1.1 likewise below 2
  scene.bodies.position[0].y = 0.7;
  const BodyArrays<Vec2> moved(scene);
  grid.prepare(exec, moved.view());
  CHECK(rows_visited(0) == 1);
}

TEST_CASE("each size class has a grid of its own, whose cells suit its spheres") {
  const Scene scene = make_cloud({.count = 400, .smallest = 0.01, .largest = 0.1, .is_log_uniform = true}, 4);
  const auto classes = BodyArrays<Vec3>(scene).parameters({}).classes;
  const std::vector<GridInspection> grids = grids_of(scene);
  REQUIRE(grids.size() == 3);
  size_t listed = 0;
  for (size_t k = 0; k < 3; ++k) {
    const std::vector<int> bodies = bodies_in(grids[k]);
    CHECK(bodies.size() == static_cast<size_t>(classes[k].count));
    CHECK(grids[k].edge.x >= 2 * classes[k].largest);
    for (const int body : bodies) CHECK(float(scene.bodies.radius[static_cast<size_t>(body)]) <= classes[k].largest);
    listed += bodies.size();
  }
  CHECK(listed == 400);
  CHECK(grids[0].edge.x > grids[2].edge.x);
}

TEST_CASE("with a cell size one grid serves all sizes, as on slide 7") {
  const Settings settings = settings_of({.cell_size = 1.0});
  const Scene scene = make_cloud({.count = 400, .smallest = 0.01, .largest = 0.1, .is_log_uniform = true}, 4);
  const std::vector<GridInspection> grids = grids_of(scene, settings);
  REQUIRE(grids.size() == 1);
  CHECK(bodies_in(grids[0]).size() == 400);
  CHECK(grids[0].edge.x ==
        Approx(2 * *std::max_element(scene.bodies.radius.begin(), scene.bodies.radius.end())).epsilon(1e-3));
}

TEST_CASE("cells are hashed where there would be far more of them than spheres, and by request") {
  const auto is_hashed = [](const Scene& scene, const char* table) {
    const auto parameters = BodyArrays<Vec3>(scene).parameters(settings_of({.table = table}));
    return SortedGrid<Vec3, CpuExecutor>(parameters).candidates().grids.grid[0].is_hashed;
  };
  const Scene loose = make_cloud({.count = 200, .smallest = 0.002, .largest = 0.002}, 1);
  const Scene tight = make_cloud({.count = 200, .smallest = 0.2, .largest = 0.2}, 1);
  CHECK(is_hashed(loose, "auto"));
  CHECK_FALSE(is_hashed(tight, "auto"));
  CHECK_FALSE(is_hashed(loose, "dense"));
  CHECK(is_hashed(tight, "hashed"));
}

TEST_CASE("memory does not grow with a domain that stays empty") {
  const auto bytes = [](double size) {
    Scene scene = make_cloud({.count = 1000, .smallest = 0.05, .largest = 0.05}, 1);
    scene.domain.max = Vec3d(size);
    const BodyArrays<Vec3> bodies(scene);
    CpuExecutor exec(1);
    SortedGrid<Vec3, CpuExecutor> grid(bodies.parameters({}));
    grid.prepare(exec, bodies.view());
    return grid.bytes();
  };
  CHECK(bytes(1e6) < 200000);
  CHECK(bytes(1e6) == bytes(1e5));
}

TEST_CASE("a huge sphere looks up no more rows of small cells than there are buckets for them") {
  for (const Boundary boundary : {Boundary::walls, Boundary::periodic}) {
    Scene scene = make_cloud({.count = 1000, .smallest = 0.001, .largest = 0.001, .boundary = boundary}, 1);
    scene.bodies.radius[0] = 0.9;
    const BodyArrays<Vec3> bodies(scene);
    CpuExecutor exec(1);
    SortedGrid<Vec3, CpuExecutor> grid(bodies.parameters({}));
    grid.prepare(exec, bodies.view());
    const auto candidates = grid.candidates();
    REQUIRE(candidates.grids.grid[1].is_hashed);
    REQUIRE(candidates.slots().body[0] == 0);
    int lookups = 0;
    candidates.for_each_range(0, [&](const SlotRange&) { ++lookups; });
    CHECK(lookups < 5000);
  }
}
